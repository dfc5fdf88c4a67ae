#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <filesystem>
#include <string>

#include "server/transport/descriptor.h"
#include "server/transport/listen_address.h"

namespace remeshd::test {

/// A connection to an address as `--listen` takes it, with a real port; not open if refused.
inline Descriptor connect_to(const std::string& address) {
  const ListenAddress target = parse_listen_address(address);
  const SocketAddress& socket = target.sockets.front();
  Descriptor connection(::socket(socket.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (::connect(connection.get(), reinterpret_cast<const sockaddr*>(&socket.storage),
                socket.size) != 0)
    connection.reset();
  return connection;
}

/// Waits until there is something to read, 10 s at most.
inline bool readable(const Descriptor& connection) {
  pollfd ready{.fd = connection.get(), .events = POLLIN, .revents = 0};
  return ::poll(&ready, 1, 10'000) == 1;
}

/// Waits until the peer has closed the connection; false after 10 s or if it sends something.
inline bool closed_by_peer(const Descriptor& connection) {
  char byte = 0;
  return readable(connection) && ::recv(connection.get(), &byte, 1, 0) <= 0;
}

/// A folder that is gone after the test.
class Folder {
 public:
  Folder()
      : path_(
            std::filesystem::temp_directory_path() /
            ("remeshd-transport-" + std::to_string(::getpid()) + "-" + std::to_string(counter++))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return path_ / name; }

 private:
  static inline int counter = 0;
  std::filesystem::path path_;
};

}  // namespace remeshd::test
