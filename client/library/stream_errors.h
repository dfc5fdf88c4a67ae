// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/status.h>

#include "remesh/v1/error.pb.h"

namespace remeshd::client {

/// What requests get that the end of their stream left unanswered.
remesh::v1::Error stream_ended();
/// An end that leaves requests unanswered is a break.
grpc::Status broken_by(const grpc::Status& end);
/// What a request gets that is not sent a second time, since it may have been carried out.
remesh::v1::Error not_sent_again();
/// What a request gets that was cancelled on this side.
remesh::v1::Error request_cancelled();

}  // namespace remeshd::client
