// SPDX-License-Identifier: Apache-2.0
#include "client/library/stream_errors.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;

}  // namespace

Error stream_ended() {
  Error error;
  error.set_code(Error::CODE_UNAVAILABLE);
  error.set_reason(Error::STREAM_ENDED);
  error.set_message("the stream ended before this request was answered");
  return error;
}

grpc::Status broken_by(const grpc::Status& end) {
  if (!end.ok()) return end;
  return {grpc::StatusCode::UNAVAILABLE, stream_ended().message()};
}

Error not_sent_again() {
  Error error = stream_ended();
  error.set_message(
      "the stream broke before this request was answered, and the daemon may have done it");
  error.set_hint("look at the head of its design");
  return error;
}

Error request_cancelled() {
  Error error;
  error.set_code(Error::CODE_CANCELLED);
  error.set_reason(Error::CANCELLED);
  error.set_message("the request was cancelled");
  return error;
}

}  // namespace remeshd::client
