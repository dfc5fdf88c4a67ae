#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "server/transport/descriptor.h"
#include "server/transport/listen_address.h"

namespace remeshd {

/// The sockets of an address, bound and listening: connections queue up in the kernel from the
/// constructor on. No other daemon can listen on the same port. The file of a Unix socket may be
/// used by its owner only (0600), and is removed with the object.
class ListeningSockets {
 public:
  /// Throws Error(FailedPrecondition) `LISTEN_FAILED`: the address is in use, or not this
  /// machine's; at the path of the Unix socket there is a file other than a stale socket of this
  /// user.
  explicit ListeningSockets(const ListenAddress& address);
  /// As `close`.
  ~ListeningSockets() { close(); }
  ListeningSockets(ListeningSockets&&) = default;
  ListeningSockets& operator=(ListeningSockets&&) = delete;

  /// Listens no more; a second call does nothing.
  void close();
  [[nodiscard]] const std::vector<Descriptor>& descriptors() const { return sockets_; }
  [[nodiscard]] bool is_unix() const { return address_.is_unix(); }
  /// The port; 0 for a Unix socket.
  [[nodiscard]] int port() const { return address_.port; }
  /// As `--listen` takes it, with the real port.
  [[nodiscard]] std::string name() const;

 private:
  bool open_all();
  void open_unix();

  ListenAddress address_;
  std::vector<Descriptor> sockets_;
  ino_t file_ = 0;  ///< of the Unix socket
};

}  // namespace remeshd
