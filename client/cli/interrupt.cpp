#include "client/cli/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <csignal>

#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

/// Wakes the waiting thread when there is nothing more to wait for.
constexpr int kEnd = SIGUSR2;

sigset_t waited_for() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, kEnd}) sigaddset(&set, signal);
  return set;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = waited_for();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::thread([this] { wait(); });
}

Interrupt::~Interrupt() {
  pthread_kill(waiter_.native_handle(), kEnd);
  waiter_.join();
}

void Interrupt::wait() {
  const sigset_t set = waited_for();
  while (true) {
    int signal = 0;
    if (sigwait(&set, &signal) != 0) continue;
    if (signal == kEnd) return;
    // A daemon in this process may take a while to stop; who asks twice does not want to wait.
    if (source_.stop_requested()) ::_exit(kInterrupted);
    source_.request_stop();
  }
}

}  // namespace remeshd::cli
