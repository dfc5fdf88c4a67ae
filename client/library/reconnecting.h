// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/status.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include "remeshd/call_options.h"

namespace remeshd::client {

/// Whether the daemon has ever answered a client. Where it never did, its address may be wrong, and
/// a call fails at once.
using Answered = std::shared_ptr<std::atomic<bool>>;

/// Whether and for how long a call that broke is made again.
class Reconnecting {
 public:
  /// `answered`: of the client whose call it is.
  Reconnecting(const CallOptions& options, Answered answered)
      : options_(options), answered_(std::move(answered)) {}

  /// The options for a call from now on: what is left of the time.
  [[nodiscard]] CallOptions rest() const;
  /// Something came: from here on a call of this client is worth another try.
  void heard();
  /// Waits a moment and says whether to try again; false for a status that is no broken connection,
  /// before the daemon ever answered, after a stop request, or where `reconnect` seconds have
  /// passed since something came.
  [[nodiscard]] bool tries_again(const grpc::Status& status);
  /// Ends the waiting, and tries no more. May be called from another thread.
  void stop() { stop_.request_stop(); }

 private:
  using Clock = std::chrono::steady_clock;

  const CallOptions options_;
  const Clock::time_point begun_ = Clock::now();
  const Answered answered_;
  std::optional<Clock::time_point> broken_since_;
  std::stop_source stop_;
};

}  // namespace remeshd::client
