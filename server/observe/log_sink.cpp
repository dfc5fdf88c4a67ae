#include "server/observe/log_sink.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace remeshd {
namespace {

int open_log(const std::filesystem::path& file) {
  return ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOCTTY, 0600);
}

/// Waits as long as it takes; false where it cannot be written.
bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t wrote = ::write(descriptor, text.data(), text.size());
    if (wrote >= 0) {
      text.remove_prefix(static_cast<std::size_t>(wrote));
    } else if (errno == EAGAIN) {
      pollfd ready{.fd = descriptor, .events = POLLOUT, .revents = 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

}  // namespace

LogSink::LogSink(std::filesystem::path file, std::unique_ptr<spdlog::formatter> format,
                 std::function<std::size_t()> overrun)
    : file_(std::move(file)), overrun_(std::move(overrun)) {
  set_formatter_(std::move(format));
  if (file_.empty()) return;
  descriptor_ = open_log(file_);
  if (descriptor_ < 0)
    throw std::system_error(errno, std::generic_category(), "log file " + file_.string());
}

LogSink::~LogSink() {
  if (!file_.empty()) ::close(descriptor_);
}

void LogSink::sink_it_(const spdlog::details::log_msg& message) {
  if (reopen_.exchange(false)) open_anew();
  tell_dropped();
  write(message);
}

void LogSink::open_anew() {
  if (file_.empty()) return;
  const int fresh = open_log(file_);
  if (fresh < 0) return warn(fmt::format("the log file cannot be opened: {}", strerror(errno)));
  ::close(std::exchange(descriptor_, fresh));
}

void LogSink::tell_dropped() {
  const std::uint64_t dropped = this->dropped();
  if (dropped == told_) return;
  const std::uint64_t fresh = dropped - std::exchange(told_, dropped);
  warn(fmt::format("{} lines of the log were dropped", fresh));
}

void LogSink::warn(const std::string& what) {
  write(spdlog::details::log_msg("remeshd", spdlog::level::warn, what));
}

void LogSink::write(const spdlog::details::log_msg& message) {
  spdlog::memory_buf_t line;
  formatter_->format(message, line);
  if (!write_all(descriptor_, {line.data(), line.size()})) ++unwritten_;
}

void LogSink::flush_() {
  const std::scoped_lock lock(flush_mutex_);
  ++flushes_;
  flushed_.notify_all();
}

std::uint64_t LogSink::flushes() const {
  const std::scoped_lock lock(flush_mutex_);
  return flushes_;
}

bool LogSink::wait_for_flush(std::uint64_t number, std::chrono::milliseconds limit) {
  std::unique_lock lock(flush_mutex_);
  return flushed_.wait_for(lock, limit, [&] { return flushes_ >= number; });
}

}  // namespace remeshd
