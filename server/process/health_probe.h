#pragma once

#include <chrono>
#include <string>

namespace remeshd {

/// What a daemon says of itself. The numbers are the exit codes of `remeshd --health`.
enum class Health { Serving = 0, NotServing = 1, Unreachable = 2 };

/// Asks the health service of a daemon for one of its names (`liveness`,
/// `remesh.v1.RemeshService`), within `limit`. `address` as a client takes it.
Health probe_health(const std::string& address, const std::string& service,
                    std::chrono::milliseconds limit);

}  // namespace remeshd
