#pragma once

#include <spdlog/logger.h>

#include <memory>

namespace remeshd {

/// Sends what gRPC logs by itself to `log`, or to nowhere (null). By default gRPC writes to stderr
/// on the calling thread, which then waits for whoever reads that.
void redirect_grpc_log(std::shared_ptr<spdlog::logger> log);

}  // namespace remeshd
