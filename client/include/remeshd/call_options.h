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
  /// s for which a transfer, stream or call that changes nothing is tried again where no daemon is
  /// available, from its first failure on; not where none has ever answered. With 0 the others of
  /// several are asked once.
  double reconnect = 30;
  /// Requests of the same route go to the same of several daemons; a balancer in between gets the
  /// digest of the route as `x-remesh-key`. Default: the design that the request names, else the
  /// design of the revision that it names (looked up where it is not known), or the root of that
  /// revision where it is in no design; for a first mesh in no design a digest of the request. A
  /// stream has the route of its first request, unless this is set.
  std::optional<std::string> route{};
};

}  // namespace remeshd::client
