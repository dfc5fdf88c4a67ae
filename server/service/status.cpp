#include "server/service/status.h"

#include <cmath>
#include <string>
#include <utility>

#include "remesh/v1/rpc_status.pb.h"
#include "server/service/encode_report.h"
#include "server/service/fitting.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

// Bytes of the parts of an error, together below the 4 KB that it may have; beyond 7 KB gRPC drops
// it altogether.
constexpr std::size_t kLongText = 500;
constexpr std::size_t kShortText = 160;
constexpr std::size_t kAllTexts = 400;  // of a list of names
constexpr std::size_t kAllAttempts = 600;

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
    case ErrorKind::DataLoss:
      return grpc::StatusCode::DATA_LOSS;
    case ErrorKind::Unimplemented:
      return grpc::StatusCode::UNIMPLEMENTED;
    case ErrorKind::PermissionDenied:
      return grpc::StatusCode::PERMISSION_DENIED;
    case ErrorKind::Unauthenticated:
      return grpc::StatusCode::UNAUTHENTICATED;
  }
  return grpc::StatusCode::INTERNAL;
}

v1::Error::Reason reason_of(const ErrorInfo& info) {
  v1::Error::Reason reason = v1::Error::REASON_UNSPECIFIED;
  v1::Error::Reason_Parse(info.reason, &reason);
  return reason;
}

/// The first of the texts, as many as there is room for.
template <typename Repeated>
void put_fitting(const std::vector<std::string>& texts, Repeated& out,
                 std::size_t most = kAllTexts) {
  std::size_t bytes = 0;
  for (const std::string& whole : texts) {
    std::string text = fitting(whole, kShortText);
    bytes += text.size() + 2;  // on the wire
    if (bytes > most) return;
    out.Add(std::move(text));
  }
}

void put_warning(const Warning& warning, v1::Warning& out) {
  Warning rest = warning;
  rest.features.clear();
  rest.groups.clear();
  out = encode(rest);
  out.set_message(fitting(warning.message, kLongText));
  put_fitting(warning.features, *out.mutable_features());
  put_fitting(warning.groups, *out.mutable_groups());
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
  out.set_reason(reason_of(info));
  out.set_message(fitting(info.message, kLongText));
  out.set_hint(fitting(info.hint, kLongText));
  out.set_stage(fitting(info.stage, kShortText));
  put_fitting(info.features, *out.mutable_features());
  out.set_parameter(fitting(info.parameter, kShortText));
  if (info.place)
    for (const double c : {info.place->x, info.place->y, info.place->z}) out.add_point(c);
  if (info.edit_index) out.set_edit_index(static_cast<std::uint32_t>(*info.edit_index));
  if (info.line) out.set_line(static_cast<std::uint32_t>(*info.line));
  if (info.column) out.set_column(static_cast<std::uint32_t>(*info.column));
  if (info.retry_after) out.set_retry_after(*info.retry_after);
  put_fitting(info.attempts, *out.mutable_attempts(), kAllAttempts);
  out.set_home(fitting(info.home, kShortText));
  if (info.warning) put_warning(*info.warning, *out.mutable_warning());
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
  info.set_reason(v1::Error::Reason_Name(message.reason()));
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

void add_pushback(const Error& error, grpc::ServerContextBase& context) noexcept {
  if (!error.info().retry_after) return;
  try {
    const double ms = std::ceil(1000 * *error.info().retry_after);
    context.AddTrailingMetadata("grpc-retry-pushback-ms", std::to_string(std::lround(ms)));
  } catch (...) {  // without memory for it, the client waits for as long as it likes
  }
}

grpc::Status to_status(const Error& error) noexcept {
  try {
    return full_status(error);
  } catch (...) {
    return {code_of(error.info().kind), ""};  // no memory left for words
  }
}

}  // namespace remeshd
