#pragma once

#include <chrono>

namespace remeshd {

/// Measures the seconds between calls and adds them to phases.
class Stopwatch {
 public:
  /// Adds the seconds since the last call, or since construction, to `phase`.
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
