#pragma once

#include "server/config/configuration.h"

namespace remeshd {

/// The daemon as a process: from settings to the signal that ends it. Pre: `block_signals` was
/// called before any thread was started.
///
/// Returns once all is at rest. Throws what Daemon and Log throw. A daemon that does not come to
/// rest ends the process with exit code 1, some seconds after the grace time.
void serve(const Configuration& configuration, Engine engine);

}  // namespace remeshd
