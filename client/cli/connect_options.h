#pragma once

#include "client/cli/run.h"

namespace remeshd::cli {

/// How to connect: the files that the options name, read.
/// Throws UsageError for a certificate without its key, FileError.
client::ConnectOptions connect_options(const GlobalOptions& options);

}  // namespace remeshd::cli
