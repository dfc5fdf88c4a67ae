#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <string>
#include <vector>

namespace remeshd {

/// An address of the kernel: IPv4, IPv6 or the path of a Unix socket.
struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;
};

/// Where a daemon is to listen.
struct ListenAddress {
  std::string host;                    ///< as it was given; empty for a Unix socket
  std::uint16_t port = 0;              ///< 0: a free one
  std::string path;                    ///< of a Unix socket, else empty
  std::vector<SocketAddress> sockets;  ///< one at least; a host name may have several

  [[nodiscard]] bool is_unix() const { return !path.empty(); }
  /// Whether this machine alone can reach it: 127.0.0.0/8, ::1, a Unix socket.
  [[nodiscard]] bool is_loopback() const;
};

/// `127.0.0.1:80`, `[::1]:80`; empty for a Unix socket.
std::string numeric(const SocketAddress& address);

/// Reads HOST:PORT or unix:/PATH. HOST is an IPv4 address of four numbers, an IPv6 address in
/// brackets, `localhost` (127.0.0.1 and ::1) or a host name that resolves; PORT has decimal digits
/// alone, 0 to 65535; PATH is absolute. Nothing is guessed: what would be another address than it
/// seems (`0`, `:80`, `127.1:80`, `dns:///x`) is refused.
///
/// Throws Error(InvalidArgument) `LISTEN_INVALID`.
ListenAddress parse_listen_address(const std::string& text);

}  // namespace remeshd
