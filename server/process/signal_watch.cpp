#include "server/process/signal_watch.h"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace remeshd {
namespace {

sigset_t watched_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  return signals;
}

Descriptor checked(int descriptor, const char* what) {
  if (descriptor < 0) throw std::system_error(errno, std::generic_category(), what);
  return Descriptor(descriptor);
}

Descriptor open_signals() {
  const sigset_t signals = watched_signals();
  return checked(::signalfd(-1, &signals, SFD_CLOEXEC), "signalfd");
}

}  // namespace

void block_signals() {
  const sigset_t signals = watched_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

SignalWatch::SignalWatch(std::function<void()> reload, std::function<void(int)> before_exit)
    : reload_(std::move(reload)),
      before_exit_(std::move(before_exit)),
      signals_(open_signals()),
      stop_(checked(::eventfd(0, EFD_CLOEXEC), "eventfd")),
      thread_([this] { run(); }) {}

SignalWatch::~SignalWatch() {
  ::eventfd_write(stop_.get(), 1);
  thread_.join();
}

void SignalWatch::serving() {
  const std::scoped_lock lock(mutex_);
  serving_ = true;
}

int SignalWatch::wait_for_end() { return ended_.get_future().get(); }

void SignalWatch::run() {
  std::array<pollfd, 2> ready{pollfd{.fd = signals_.get(), .events = POLLIN, .revents = 0},
                              pollfd{.fd = stop_.get(), .events = POLLIN, .revents = 0}};
  while (true) {
    if (::poll(ready.data(), ready.size(), -1) < 0) continue;
    if (ready[1].revents != 0) return;
    signalfd_siginfo info{};
    if (::read(signals_.get(), &info, sizeof(info)) != sizeof(info)) continue;
    const int signal = static_cast<int>(info.ssi_signo);
    if (signal == SIGHUP)
      reload_();
    else
      end(signal);
  }
}

void SignalWatch::end(int signal) {
  const std::scoped_lock lock(mutex_);
  if (serving_ && !std::exchange(ending_, true)) return ended_.set_value(signal);
  before_exit_(signal);
  std::_Exit(serving_ ? 128 + signal : EXIT_SUCCESS);
}

}  // namespace remeshd
