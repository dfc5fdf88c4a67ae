#pragma once

#include <spdlog/logger.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace remeshd {

struct LogOptions {
  std::string level = "info";   ///< as spdlog names them
  std::string format = "text";  ///< or `json`: one object a line
  std::filesystem::path file;   ///< empty: stderr
  std::size_t queue = 8192;     ///< lines that may wait to be written
};

/// The daemon's log. Lines are written by a thread of the log's own: whoever logs never waits for
/// the file or for whoever reads stderr. Where more lines wait than may, the oldest are dropped,
/// and a line tells how many.
class Log {
 public:
  /// A new file is its owner's alone (0600). Throws std::system_error where it cannot be opened.
  explicit Log(const LogOptions& options);
  /// Waits a second at most for what is still to be written.
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  /// For any thread. Must not be used after the log has gone.
  [[nodiscard]] std::shared_ptr<spdlog::logger> logger() const;
  /// Opens the file anew before the next line, for whoever has renamed it. Where that fails the old
  /// one stays, and a line tells so.
  void reopen();
  /// Waits until everything logged so far is written, `limit` at most; whether it is.
  bool flush(std::chrono::milliseconds limit);
  /// Lines that were never written.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remeshd
