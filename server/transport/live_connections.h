#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <unordered_map>

namespace remeshd {

/// Counts connections whose owner (gRPC) closes them without telling. A connection is remembered by
/// its descriptor and the inode number of its socket: once the descriptor is closed, or stands for
/// another inode, the connection is gone.
class LiveConnections {
 public:
  explicit LiveConnections(std::size_t limit) : limit_(limit) {}

  /// Remembers an open connection; false, and not remembered, if the limit is reached.
  bool admit(int descriptor);
  /// Number of open connections.
  [[nodiscard]] std::size_t count();
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  using Clock = std::chrono::steady_clock;
  void forget_closed();

  std::size_t limit_;
  std::unordered_map<int, ino_t> sockets_;  ///< by descriptor; some may be closed already
  Clock::time_point looked_{};
};

}  // namespace remeshd
