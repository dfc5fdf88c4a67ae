#pragma once

#include <chrono>

namespace remeshd {

/// Adds up the seconds between calls, each to a phase.
class Stopwatch {
 public:
  /// The time since the last call goes to `phase`.
  void lap(double& phase) {
    const auto now = Clock::now();
    phase += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  [[nodiscard]] double total() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace remeshd
