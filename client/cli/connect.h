#pragma once

#include "client/cli/run.h"

namespace remeshd::cli {

/// The way to the daemon that the options name: over the network, or for `--local` one in this
/// process, which lives as long as the client.
client::Client connect(const GlobalOptions& options);

}  // namespace remeshd::cli
