#pragma once

#include <stop_token>
#include <thread>

namespace remeshd::cli {

/// Turns SIGINT and SIGTERM into a stop request; a second one ends the process at once.
///
/// Make it before any other thread: it blocks the signals for all threads that start after it.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  void wait();

  std::stop_source source_;
  std::thread waiter_;
};

}  // namespace remeshd::cli
