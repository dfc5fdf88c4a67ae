#pragma once

#include <spdlog/logger.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "server/transport/descriptor.h"
#include "server/transport/listening_sockets.h"
#include "server/transport/live_connections.h"

namespace remeshd {

/// Accepts connections on a thread of its own and hands them over. It never waits for a peer: one
/// that connects and says nothing holds nobody up. Above the limit a connection is closed at once.
/// Without descriptors or memory for another one, waiting connections are refused, and the loop
/// goes on.
class AcceptLoop {
 public:
  /// Takes the connection's descriptor; called on the loop's thread.
  using HandOver = std::function<void(int listener, Descriptor connection)>;

  /// `log` may be null.
  AcceptLoop(std::vector<ListeningSockets> sockets, std::size_t max_connections, HandOver hand_over,
             std::shared_ptr<spdlog::logger> log);
  /// As `stop`.
  ~AcceptLoop();
  AcceptLoop(const AcceptLoop&) = delete;
  AcceptLoop& operator=(const AcceptLoop&) = delete;

  [[nodiscard]] const std::vector<ListeningSockets>& sockets() const { return sockets_; }
  /// Number of open connections; may be some milliseconds old.
  [[nodiscard]] std::size_t count() const;
  /// Hands nothing over once this has returned, and listens no more.
  void stop();

 private:
  using Clock = std::chrono::steady_clock;
  enum class Outcome { Accepted, None, NoRoom };

  void run();
  /// False once the loop is to end.
  bool wait_for_stop(std::chrono::milliseconds pause) const;
  Outcome accept_from(int listener) noexcept;
  void admit(int listener, Descriptor connection);
  bool remember(int connection);
  bool refuse_one(int listener);
  void warn(const char* what);

  std::vector<ListeningSockets> sockets_;
  mutable std::mutex live_mutex_;
  mutable LiveConnections live_;  ///< mutable: `count` drops those that are closed
  HandOver hand_over_;
  std::shared_ptr<spdlog::logger> log_;
  Descriptor wake_;   ///< readable once the loop is to end
  Descriptor spare_;  ///< given up for a moment to refuse a connection when there is none left
  Clock::time_point warned_{};
  std::uint64_t refused_ = 0;  ///< since the last warning
  std::thread thread_;
};

}  // namespace remeshd
