// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stop_token>

namespace remeshd::client {

/// How one call behaves.
struct CallOptions {
  std::stop_token stop;           ///< a stop request cancels the call: CallError CANCELLED
  std::optional<double> timeout;  ///< s; afterwards CallError DEADLINE_EXCEEDED
  /// s for which a transfer, stream or call that changes nothing is tried again where the
  /// connection to a daemon that has answered before is broken.
  double reconnect = 30;
};

}  // namespace remeshd::client
