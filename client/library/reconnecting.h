// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <optional>
#include <stop_token>

#include "remeshd/call_options.h"

namespace remeshd::client {

/// Whether and for how long a call that broke is made again.
class Reconnecting {
 public:
  explicit Reconnecting(const CallOptions& options) : options_(options) {}

  /// The options for a call from now on: what is left of the time.
  [[nodiscard]] CallOptions rest() const;
  /// Something came: from here on it is worth another try.
  void heard();
  /// Waits a moment and says whether to try again; false for a status that is no broken connection,
  /// before anything was heard, after a stop request, or where `reconnect` seconds passed since.
  [[nodiscard]] bool tries_again(const grpc::Status& status);
  /// Ends the waiting, and tries no more. May be called from another thread.
  void stop() { stop_.request_stop(); }

 private:
  using Clock = std::chrono::steady_clock;

  const CallOptions options_;
  const Clock::time_point begun_ = Clock::now();
  bool heard_ = false;
  std::optional<Clock::time_point> broken_since_;
  std::stop_source stop_;
};

}  // namespace remeshd::client
