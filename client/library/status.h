// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/status.h>

#include "remeshd/error.h"

namespace remeshd::client {

/// The error that a failed status carries: the remesh.v1.Error in its details, or one made of the
/// status's own code and message where it has none.
remesh::v1::Error error_of(const grpc::Status& status);

/// Throws CallError unless the status is OK.
void check(const grpc::Status& status);

}  // namespace remeshd::client
