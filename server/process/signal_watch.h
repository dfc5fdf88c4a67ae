#pragma once

#include <csignal>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "server/transport/descriptor.h"

namespace remeshd {

/// Blocks SIGTERM, SIGINT and SIGHUP in this thread and those that it starts, so that a SignalWatch
/// alone sees them, and ignores SIGPIPE. To be called first in the process.
void block_signals();

/// Hears the signals of the process on a thread of its own.
///
/// While nothing is served yet, SIGTERM and SIGINT end the process at once with exit code 0: a
/// store may be left at any moment of its opening. Afterwards the first is told by `wait_for_end`,
/// and a second ends the process at once with 128 plus its number. SIGHUP calls `reload`.
class SignalWatch {
 public:
  /// `before_exit`: called before this class ends the process; must not block for long.
  SignalWatch(std::function<void()> reload, std::function<void(int signal)> before_exit);
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// From now on a first signal does not end the process by itself.
  void serving();
  /// Waits for the signal that is to end the daemon and returns it. To be called once.
  int wait_for_end();

 private:
  void run();
  void end(int signal);

  const std::function<void()> reload_;
  const std::function<void(int)> before_exit_;
  Descriptor signals_, stop_;
  std::mutex mutex_;
  bool serving_ = false, ending_ = false;
  std::promise<int> ended_;
  std::thread thread_;
};

}  // namespace remeshd
