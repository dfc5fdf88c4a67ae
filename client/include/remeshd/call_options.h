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
  /// Requests of one route go to one of several daemons; a balancer in between gets its digest as
  /// `x-remesh-key`. Default: the design that is named, or else that of the revision that is, which
  /// is looked up where it is not known, or its root where it is in none; of a first mesh in no
  /// design its own digest. Of a stream that of its first request, unless this says otherwise.
  std::optional<std::string> route{};
};

}  // namespace remeshd::client
