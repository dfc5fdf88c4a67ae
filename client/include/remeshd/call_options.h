// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>

namespace remeshd::client {

/// How one call behaves.
struct CallOptions {
  std::stop_token stop;           ///< a stop request cancels the call: CallError CANCELLED
  std::optional<double> timeout;  ///< s; afterwards CallError DEADLINE_EXCEEDED
  /// s, from the first failure on, for which a transfer, a stream or a call that changes nothing is
  /// tried again while no daemon is available. Nothing is tried again if no daemon has ever
  /// answered. With 0, each of several daemons is asked once.
  double reconnect = 30;
  /// Where there are several daemons, requests of the same route go to the same one; a load
  /// balancer gets a digest of the route in the metadata `x-remesh-key`. Default, in this order:
  /// the design that the request names; the design of the revision that it names (looked up if not
  /// known); the root of that revision, if it is in no design; for a first mesh in no design, a
  /// digest of the request. A stream has the route of its first request, unless this is set.
  std::optional<std::string> route{};
};

}  // namespace remeshd::client
