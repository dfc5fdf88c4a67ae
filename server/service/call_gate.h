#pragma once

#include <chrono>
#include <cstddef>
#include <memory>

namespace remeshd {

/// Lets work in until the daemon is to end, and knows when all that it let in is done.
class CallGate {
 public:
  /// Held by work that was let in; the last copy gone, the work counts as done. May outlive the
  /// gate.
  using Pass = std::shared_ptr<void>;

  CallGate();

  /// Throws Error(Unavailable) `SHUTTING_DOWN`, with a delay, once the gate is closed.
  [[nodiscard]] Pass enter();
  void close();
  [[nodiscard]] bool closed() const;
  /// Returns when no pass is out, or after `limit`; whether none is.
  bool wait_until_empty(std::chrono::duration<double> limit);

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace remeshd
