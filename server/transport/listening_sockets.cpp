#include "server/transport/listening_sockets.h"

#include <netinet/in.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstddef>
#include <cstring>

#include "engine/base/error.h"

namespace remeshd {
namespace {

Error listen_failed(const std::string& name, const std::string& why) {
  ErrorInfo info;
  info.kind = ErrorKind::FailedPrecondition;
  info.reason = "LISTEN_FAILED";
  info.message = "cannot listen on " + name + ": " + why;
  info.stage = "request";
  info.hint = "is another daemon listening there?";
  return Error(std::move(info));
}

Error listen_failed(const ListenAddress& address, int error) {
  const std::string name = address.is_unix() ? "unix:" + address.path
                                             : address.host + ':' + std::to_string(address.port);
  return listen_failed(name, std::strerror(error));
}

const sockaddr* kernel(const SocketAddress& address) {
  return reinterpret_cast<const sockaddr*>(&address.storage);
}

void set_port(SocketAddress& address, std::uint16_t port) {
  // The port lies at the same place in both families.
  static_assert(offsetof(sockaddr_in, sin_port) == offsetof(sockaddr_in6, sin6_port));
  reinterpret_cast<sockaddr_in*>(&address.storage)->sin_port = htons(port);
}

std::uint16_t port_of(int socket) {
  SocketAddress address{.size = sizeof(sockaddr_storage)};
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address.storage), &address.size);
  return ntohs(reinterpret_cast<const sockaddr_in*>(&address.storage)->sin_port);
}

Descriptor new_socket(int family) {
  return Descriptor(::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// A listening socket, or errno in `error`. No SO_REUSEPORT: a second daemon on the same port would
/// take half of the calls.
Descriptor listen_on(const SocketAddress& address, int& error) {
  constexpr int kOn = 1;
  constexpr int kOff = 0;
  Descriptor socket = new_socket(address.storage.ss_family);
  if (socket.is_open() && address.storage.ss_family != AF_UNIX) {
    ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &kOn, sizeof(kOn));
    if (address.storage.ss_family == AF_INET6)
      ::setsockopt(socket.get(), IPPROTO_IPV6, IPV6_V6ONLY, &kOff, sizeof(kOff));
  }
  // The mode set on a socket that is not bound yet becomes that of its file.
  if (socket.is_open() && address.storage.ss_family == AF_UNIX) ::fchmod(socket.get(), 0600);
  if (!socket.is_open() || ::bind(socket.get(), kernel(address), address.size) != 0 ||
      ::listen(socket.get(), SOMAXCONN) != 0) {
    error = errno;
    socket.reset();
  }
  return socket;
}

/// Removes the file of a socket of this user on which nobody listens. Throws Error `LISTEN_FAILED`
/// for any other file.
void remove_stale(const ListenAddress& address) {
  struct stat file {};
  if (::lstat(address.path.c_str(), &file) != 0) return;
  if (!S_ISSOCK(file.st_mode) || file.st_uid != ::geteuid())
    throw listen_failed("unix:" + address.path, "there is another file of this name");
  const Descriptor probe = new_socket(AF_UNIX);
  const SocketAddress& socket = address.sockets.front();
  if (::connect(probe.get(), kernel(socket), socket.size) == 0 || errno != ECONNREFUSED)
    throw listen_failed(address, EADDRINUSE);
  ::unlink(address.path.c_str());
}

}  // namespace

ListeningSockets::ListeningSockets(const ListenAddress& address) : address_(address) {
  if (address_.is_unix()) {
    open_unix();
    return;
  }
  // The free port found for the first address may be in use on the next one: then another is tried.
  for (int attempt = 1; !open_all(); ++attempt)
    if (attempt == 10) throw listen_failed(address_, EADDRINUSE);
}

void ListeningSockets::open_unix() {
  remove_stale(address_);
  int error = 0;
  Descriptor socket = listen_on(address_.sockets.front(), error);
  if (!socket.is_open()) throw listen_failed(address_, error);
  struct stat file {};
  if (::lstat(address_.path.c_str(), &file) == 0) file_ = file.st_ino;
  sockets_.push_back(std::move(socket));
}

bool ListeningSockets::open_all() {
  std::uint16_t port = address_.port;
  int last_error = EADDRNOTAVAIL;
  sockets_.clear();
  for (SocketAddress address : address_.sockets) {
    set_port(address, port);
    int error = 0;
    Descriptor socket = listen_on(address, error);
    if (!socket.is_open()) {
      last_error = error;
      // A host name may resolve to an address family that this machine lacks.
      if (error == EADDRNOTAVAIL || error == EAFNOSUPPORT) continue;
      if (error == EADDRINUSE && address_.port == 0) return false;
      throw listen_failed(address_, error);
    }
    port = port_of(socket.get());
    sockets_.push_back(std::move(socket));
  }
  if (sockets_.empty()) throw listen_failed(address_, last_error);
  address_.port = port;
  return true;
}

void ListeningSockets::close() {
  if (sockets_.empty()) return;
  struct stat file {};
  if (address_.is_unix() && ::lstat(address_.path.c_str(), &file) == 0 && file.st_ino == file_)
    ::unlink(address_.path.c_str());
  sockets_.clear();
}

std::string ListeningSockets::name() const {
  if (address_.is_unix()) return "unix:" + address_.path;
  return address_.host + ':' + std::to_string(address_.port);
}

}  // namespace remeshd
