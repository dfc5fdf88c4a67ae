#pragma once

#include <spdlog/formatter.h>
#include <spdlog/sinks/base_sink.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string_view>

namespace remeshd {

/// `2026-11-23T10:36:08.123+00:00 info message`; control characters of the message become `_`.
std::unique_ptr<spdlog::formatter> make_text_format();

/// `{"time":"2026-11-23T10:36:08.123Z","level":"info","message":"..."}`. A message made of
/// `name=value` words alone, as the line of a call, gives its names as fields too, behind
/// `message`.
std::unique_ptr<spdlog::formatter> make_json_format();

/// Writes lines to stderr or a file, as the log's one thread hands them over, and counts those that
/// it could not write.
class LogSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  /// `overrun`: returns how many lines the queue before the sink has dropped so far.
  LogSink(std::filesystem::path file, std::unique_ptr<spdlog::formatter> format,
          std::function<std::size_t()> overrun);
  ~LogSink() override;

  void reopen() { reopen_ = true; }
  [[nodiscard]] std::uint64_t dropped() const { return overrun_() + unwritten_; }
  /// Number of flushes so far; at each of them all earlier lines have been written.
  [[nodiscard]] std::uint64_t flushes() const;
  bool wait_for_flush(std::uint64_t number, std::chrono::milliseconds limit);

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override;
  void flush_() override;

 private:
  void open_anew();
  void tell_dropped();
  void write(const spdlog::details::log_msg& message);
  void warn(const std::string& what);

  const std::filesystem::path file_;
  const std::function<std::size_t()> overrun_;
  int descriptor_ = 2;
  std::atomic<bool> reopen_ = false;
  std::atomic<std::uint64_t> unwritten_ = 0;
  std::uint64_t told_ = 0;  ///< dropped lines that a warning has told of

  mutable std::mutex flush_mutex_;
  std::condition_variable flushed_;
  std::uint64_t flushes_ = 0;
};

}  // namespace remeshd
