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

// Objects that are written at a time: a bucket takes 50 to 100 ms for each.
constexpr int kWriters = 4;
// Pause after a failure; the breaker spares the store frequent attempts.
constexpr std::chrono::milliseconds kPause(250);

}  // namespace

Outbox::Outbox(fs::path folder, Again again, Write write)
    : folder_(std::move(folder)), again_(again), write_(std::move(write)) {
  make_folder(folder_);
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  for (const auto& entry : fs::directory_iterator(folder_))
    found.emplace_back(entry.last_write_time(), entry.path().filename().string());
  std::ranges::sort(found);
  for (const auto& [time, name] : found) list(name, next_place_++);
  for (int i = 0; i < kWriters; ++i)
    threads_.emplace_back([this](const std::stop_token& stop) { run(stop); });
}

Outbox::~Outbox() {
  for (std::jthread& thread : threads_) thread.request_stop();
}

void Outbox::list(const std::string& name, std::uint64_t place) {
  waiting_[name] = place;
  order_[place] = name;
}

std::uint64_t Outbox::unlist(const std::string& name) {
  const auto found = waiting_.find(name);
  const std::uint64_t place = found->second;
  waiting_.erase(found);
  order_.erase(place);
  return place;
}

void Outbox::add(const std::string& name) {
  {
    const std::scoped_lock lock(mutex_);
    if (waiting_.contains(name)) return;
    list(name, next_place_++);
    changed_.notify_all();
  }
  try {
    const File mark(folder_ / name, O_WRONLY | O_CREAT);
    mark.sync();
    sync_folder(folder_);
  } catch (const Error&) {
    // On a full disk the name waits in memory alone.
  }
  const std::scoped_lock lock(mutex_);
  if (!waiting_.contains(name) && !writing_.contains(name)) remove_mark(name);  // written meanwhile
}

void Outbox::write_now(const std::string& name) {
  std::uint64_t place = 0;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !writing_.contains(name); });
    if (!waiting_.contains(name)) return;
    place = unlist(name);
    writing_.insert(name);
  }
  write_taken(name, place);
}

void Outbox::write_taken(const std::string& name, std::uint64_t place) {
  const auto again = [&] {
    const std::scoped_lock lock(mutex_);
    writing_.erase(name);
    if (!waiting_.contains(name)) list(name, again_ == Again::InPlace ? place : next_place_++);
    changed_.notify_all();
  };
  try {
    write_(name);
  } catch (const Error& failure) {
    failure.info().reason == "TIER_REFUSED" ? finish(name) : again();
    throw;
  } catch (...) {
    again();
    throw;
  }
  finish(name);
}

/// Ends the writing of a name: its file goes, unless the name is to be written once more.
void Outbox::finish(const std::string& name) {
  const std::scoped_lock lock(mutex_);
  writing_.erase(name);
  changed_.notify_all();
  if (!waiting_.contains(name)) remove_mark(name);
}

void Outbox::remove_mark(const std::string& name) {
  try {
    remove_file(folder_ / name);
  } catch (const Error&) {
    // The file stays, and the next process writes the name once more.
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

void Outbox::run(const std::stop_token& stop) {
  const auto next = [this] {  // one that is not just being written
    return std::ranges::find_if(order_,
                                [&](const auto& e) { return !writing_.contains(e.second); });
  };
  for (;;) {
    std::string name;
    std::uint64_t place = 0;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return next() != order_.end(); })) return;
      if (stop.stop_requested()) return;
      name = next()->second;
      place = unlist(name);
      writing_.insert(name);
    }
    try {
      write_taken(name, place);
    } catch (const std::exception&) {  // the breaker tells of it
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, stop, kPause, [] { return false; });
    }
  }
}

}  // namespace remeshd
