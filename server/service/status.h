#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/status.h>

#include "engine/base/error.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd {

/// What clients get to know of an Error: at most 4 KB, valid UTF-8. A reason that the protocol does
/// not know becomes REASON_UNSPECIFIED; a test of the tree's structure finds it.
remesh::v1::Error to_message(const Error& error);

/// The status that ends a call, with the message above, a google.rpc.ErrorInfo and, where there is
/// a delay to keep, a google.rpc.RetryInfo in its details. Without memory for them, the code alone.
grpc::Status to_status(const Error& error) noexcept;

/// Tells gRPC's own retries how long to wait, where there is a delay to keep: trailing metadata
/// `grpc-retry-pushback-ms`. Before the status is sent.
void add_pushback(const Error& error, grpc::ServerContextBase& context) noexcept;

/// The status where memory does not even suffice for an Error.
inline grpc::Status out_of_memory_status() noexcept {
  return {grpc::StatusCode::RESOURCE_EXHAUSTED, ""};
}

}  // namespace remeshd
