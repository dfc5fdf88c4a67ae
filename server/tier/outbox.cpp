#include "server/tier/outbox.h"

#include <fcntl.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "server/store/files.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

// Between tries of what failed; the breaker spares the store more of them.
constexpr std::chrono::milliseconds kPause(250);

}  // namespace

Outbox::Outbox(fs::path folder, Again again, Write write)
    : folder_(std::move(folder)), again_(again), write_(std::move(write)) {
  make_folder(folder_);
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  for (const auto& entry : fs::directory_iterator(folder_))
    found.emplace_back(entry.last_write_time(), entry.path().filename().string());
  std::ranges::sort(found);
  for (auto& [time, name] : found)
    if (waiting_.insert(name).second) order_.push_back(std::move(name));
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Outbox::~Outbox() = default;

void Outbox::add(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  if (waiting_.contains(name)) return;
  try {
    const File mark(folder_ / name, O_WRONLY | O_CREAT);
  } catch (const Error&) {
    // On a disk that is full it waits in memory alone.
  }
  waiting_.insert(name);
  order_.push_back(name);
  changed_.notify_all();
}

void Outbox::write_now(const std::string& name) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !writing_.contains(name); });
    if (!waiting_.contains(name)) return;
    writing_.insert(name);
    waiting_.erase(name);
  }
  try {
    write_(name);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    writing_.erase(name);
    if (waiting_.insert(name).second)
      order_.insert(again_ == Again::First ? order_.begin() : order_.end(), name);
    changed_.notify_all();
    throw;
  }
  take_off(name);
}

/// Its mark goes, unless it is to be written once more.
void Outbox::take_off(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  writing_.erase(name);
  changed_.notify_all();
  if (waiting_.contains(name)) return;
  try {
    remove_file(folder_ / name);
  } catch (const Error&) {
    // It is written once more by the next process.
  }
}

bool Outbox::has(const std::string& name) const {
  const std::scoped_lock lock(mutex_);
  return waiting_.contains(name) || writing_.contains(name);
}

std::size_t Outbox::size() const {
  const std::scoped_lock lock(mutex_);
  return waiting_.size() + writing_.size();
}

bool Outbox::write_one(const std::string& name) {
  try {
    write_now(name);
    return true;
  } catch (const std::exception&) {
    return false;  // the breaker tells of it
  }
}

void Outbox::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::string name;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return !order_.empty(); })) return;
      name = std::move(order_.front());
      order_.pop_front();
    }
    if (write_one(name)) continue;
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, kPause, [] { return false; });
  }
}

}  // namespace remeshd
