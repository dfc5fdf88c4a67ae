#pragma once

#include <grpcpp/support/status.h>

#include "remesh/v1/error.pb.h"
#include "remesh/v1/rpc_status.pb.h"

namespace remeshd::client {

/// A status that carries `error` in its details, as the daemon sends it.
inline grpc::Status status_of(const remesh::v1::Error& error) {
  remesh::v1::RpcStatus rich;
  rich.set_code(static_cast<int>(error.code()));
  rich.set_message(error.message());
  rich.add_details()->PackFrom(error);
  return {static_cast<grpc::StatusCode>(error.code()), error.message(), rich.SerializeAsString()};
}

inline remesh::v1::Error make_error(remesh::v1::Error::Code code,
                                    remesh::v1::Error::Reason reason) {
  remesh::v1::Error error;
  error.set_code(code);
  error.set_reason(reason);
  error.set_message("told by the test");
  return error;
}

}  // namespace remeshd::client
