#pragma once

#include <spdlog/logger.h>

#include <memory>

namespace remeshd {

/// Sends what gRPC logs by itself to `log`, or to nowhere (null). gRPC would write to stderr on the
/// thread of whoever calls, which waits for its reader.
void redirect_grpc_log(std::shared_ptr<spdlog::logger> log);

}  // namespace remeshd
