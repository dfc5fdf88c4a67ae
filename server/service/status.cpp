#include "server/service/status.h"

#include <cmath>
#include <string>

#include "remesh/v1/rpc_status.pb.h"
#include "server/service/fitting.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

// Together below the 4 KB that an error may have; beyond 7 KB gRPC drops it altogether.
constexpr std::size_t kLongText = 600;
constexpr std::size_t kShortText = 160;

grpc::StatusCode code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::InvalidArgument:
      return grpc::StatusCode::INVALID_ARGUMENT;
    case ErrorKind::NotFound:
      return grpc::StatusCode::NOT_FOUND;
    case ErrorKind::FailedPrecondition:
      return grpc::StatusCode::FAILED_PRECONDITION;
    case ErrorKind::DeadlineExceeded:
      return grpc::StatusCode::DEADLINE_EXCEEDED;
    case ErrorKind::ResourceExhausted:
      return grpc::StatusCode::RESOURCE_EXHAUSTED;
    case ErrorKind::Aborted:
      return grpc::StatusCode::ABORTED;
    case ErrorKind::Cancelled:
      return grpc::StatusCode::CANCELLED;
    case ErrorKind::Unavailable:
      return grpc::StatusCode::UNAVAILABLE;
    case ErrorKind::Internal:
      return grpc::StatusCode::INTERNAL;
  }
  return grpc::StatusCode::INTERNAL;
}

template <typename Message>
void pack(const Message& message, const char* published_name, v1::RpcStatus& status) {
  google::protobuf::Any& any = *status.add_details();
  any.set_type_url(std::string("type.googleapis.com/") + published_name);
  any.set_value(message.SerializeAsString());
}

}  // namespace

v1::Error to_message(const Error& error) {
  const ErrorInfo& info = error.info();
  v1::Error out;
  out.set_code(static_cast<v1::Error::Code>(code_of(info.kind)));
  out.set_reason(fitting(info.reason, kShortText));
  out.set_message(fitting(info.message, kLongText));
  out.set_stage(fitting(info.stage, kShortText));
  out.set_feature(fitting(info.feature, kShortText));
  out.set_parameter(fitting(info.parameter, kShortText));
  out.set_hint(fitting(info.hint, kLongText));
  if (info.edit_index) out.set_edit_index(static_cast<std::uint32_t>(*info.edit_index));
  if (info.retry_after) out.set_retry_after(*info.retry_after);
  return out;
}

namespace {

grpc::Status full_status(const Error& error) {
  const v1::Error message = to_message(error);
  v1::RpcStatus status;
  status.set_code(message.code());
  status.set_message(message.message());
  pack(message, "remesh.v1.Error", status);
  v1::RpcErrorInfo info;
  info.set_reason(message.reason());
  info.set_domain("remesh.v1");
  pack(info, "google.rpc.ErrorInfo", status);
  if (message.has_retry_after()) {
    const double seconds = std::floor(message.retry_after());
    v1::RpcRetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(static_cast<std::int64_t>(seconds));
    retry.mutable_retry_delay()->set_nanos(
        static_cast<std::int32_t>((message.retry_after() - seconds) * 1e9));
    pack(retry, "google.rpc.RetryInfo", status);
  }
  return {static_cast<grpc::StatusCode>(message.code()), message.message(),
          status.SerializeAsString()};
}

}  // namespace

grpc::Status to_status(const Error& error) noexcept {
  try {
    return full_status(error);
  } catch (...) {
    return {code_of(error.info().kind), ""};  // no memory left for words
  }
}

}  // namespace remeshd
