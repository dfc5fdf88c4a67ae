#include "server/transport/accept_loop.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "server/limits.h"

namespace remeshd {
namespace {

Descriptor open_wake() {
  Descriptor wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!wake.is_open()) throw std::system_error(errno, std::generic_category(), "eventfd");
  return wake;
}

Descriptor open_spare() { return Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)); }

/// Sets the socket options that gRPC sets on connections which it accepts itself; fails harmlessly
/// for a Unix socket.
void prepare(int connection) {
  constexpr int kOn = 1;
  constexpr int kTimeout = limits::kKeepaliveTimeoutMs;
  ::setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &kOn, sizeof(kOn));
  ::setsockopt(connection, IPPROTO_TCP, TCP_USER_TIMEOUT, &kTimeout, sizeof(kTimeout));
}

}  // namespace

AcceptLoop::AcceptLoop(std::vector<ListeningSockets> sockets, std::size_t max_connections,
                       HandOver hand_over, std::shared_ptr<spdlog::logger> log)
    : sockets_(std::move(sockets)),
      live_(max_connections),
      hand_over_(std::move(hand_over)),
      log_(std::move(log)),
      wake_(open_wake()),
      spare_(open_spare()),
      thread_([this] { run(); }) {}

AcceptLoop::~AcceptLoop() { stop(); }

void AcceptLoop::stop() {
  if (!thread_.joinable()) return;
  ::eventfd_write(wake_.get(), 1);
  thread_.join();
  for (ListeningSockets& sockets : sockets_) sockets.close();
}

bool AcceptLoop::wait_for_stop(std::chrono::milliseconds pause) const {
  pollfd wake{.fd = wake_.get(), .events = POLLIN, .revents = 0};
  ::poll(&wake, 1, static_cast<int>(pause.count()));
  return wake.revents == 0;
}

void AcceptLoop::run() {
  constexpr int kAtATime = 64;  // connections from one address before the others' turn
  std::vector<pollfd> ready{{.fd = wake_.get(), .events = POLLIN, .revents = 0}};
  for (const ListeningSockets& sockets : sockets_)
    for (const Descriptor& listener : sockets.descriptors())
      ready.push_back({.fd = listener.get(), .events = POLLIN, .revents = 0});
  while (true) {
    ::poll(ready.data(), ready.size(), -1);
    if (ready.front().revents != 0) return;
    for (std::size_t i = 1; i < ready.size(); ++i) {
      if (ready[i].revents == 0) continue;
      Outcome outcome = Outcome::Accepted;
      for (int n = 0; n < kAtATime && outcome == Outcome::Accepted; ++n)
        outcome = accept_from(ready[i].fd);
      // The connection that found no room still waits, and `poll` would return at once.
      if (outcome == Outcome::NoRoom && !wait_for_stop(std::chrono::milliseconds(50))) return;
    }
  }
}

AcceptLoop::Outcome AcceptLoop::accept_from(int listener) noexcept try {
  Descriptor connection(::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (connection.is_open()) {
    admit(listener, std::move(connection));
    return Outcome::Accepted;
  }
  switch (errno) {
    case EAGAIN:
      return Outcome::None;
    case EINTR:
    case ECONNABORTED:  // this and the following: the peer has gone already (accept(2))
    case EPROTO:
    case ENETDOWN:
    case ENOPROTOOPT:
    case EHOSTDOWN:
    case ENONET:
    case EHOSTUNREACH:
    case EOPNOTSUPP:
    case ENETUNREACH:
      return Outcome::Accepted;
    case EMFILE:
    case ENFILE:
      warn("no descriptor is left for another one");
      return refuse_one(listener) ? Outcome::Accepted : Outcome::NoRoom;
    default:
      warn("the system has no room for another one");
      return Outcome::NoRoom;
  }
} catch (...) {  // no memory: the connection has been closed, the next one may do better
  return Outcome::NoRoom;
}

std::size_t AcceptLoop::count() const {
  const std::scoped_lock lock(live_mutex_);
  return live_.count();
}

bool AcceptLoop::remember(int connection) {
  const std::scoped_lock lock(live_mutex_);
  return live_.admit(connection);
}

void AcceptLoop::admit(int listener, Descriptor connection) {
  if (!remember(connection.get())) return warn("there are as many as --max-connections allows");
  prepare(connection.get());
  hand_over_(listener, std::move(connection));
}

bool AcceptLoop::refuse_one(int listener) {
  spare_.reset();
  Descriptor connection(::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC));
  const bool refused = connection.is_open();
  connection.reset();
  spare_ = open_spare();
  return refused;
}

void AcceptLoop::warn(const char* what) {
  constexpr std::chrono::seconds kBetween(10);
  ++refused_;
  const Clock::time_point now = Clock::now();
  if (!log_ || now - warned_ < kBetween) return;
  log_->warn("connections refused: {}, for {}", refused_, what);
  warned_ = now;
  refused_ = 0;
}

}  // namespace remeshd
