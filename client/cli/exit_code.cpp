#include "client/cli/exit_code.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace remeshd::cli {
namespace {

using remesh::v1::Error;

/// Failures that are the model's own fault although they show only while it is built, or although
/// the limit belongs to the daemon.
constexpr std::array<std::string_view, 5> kFaultsOfTheModel{
    "EmptyModel", "DisconnectedModel", "NonManifoldModel", "DocumentTooLarge", "DocumentTooDeep"};

/// What gRPC itself says of a message over the daemon's limit, which a document in it caused.
bool is_oversized(const Error& error) {
  return error.code() == Error::RESOURCE_EXHAUSTED && error.reason().empty() &&
         error.message().find("larger than max") != std::string::npos;
}

Error::Code code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::InvalidArgument:
      return Error::INVALID_ARGUMENT;
    case ErrorKind::NotFound:
      return Error::NOT_FOUND;
    case ErrorKind::FailedPrecondition:
      return Error::FAILED_PRECONDITION;
    case ErrorKind::DeadlineExceeded:
      return Error::DEADLINE_EXCEEDED;
    case ErrorKind::ResourceExhausted:
      return Error::RESOURCE_EXHAUSTED;
    case ErrorKind::Aborted:
      return Error::ABORTED;
    case ErrorKind::Cancelled:
      return Error::CANCELLED;
    case ErrorKind::Unavailable:
      return Error::UNAVAILABLE;
    case ErrorKind::Internal:
      return Error::INTERNAL;
  }
  return Error::UNKNOWN;
}

}  // namespace

ExitCode exit_code(const Error& error) {
  if (std::ranges::find(kFaultsOfTheModel, error.reason()) != kFaultsOfTheModel.end() ||
      is_oversized(error))
    return kInvalid;
  switch (error.code()) {
    case Error::INVALID_ARGUMENT:
    case Error::NOT_FOUND:
    case Error::ALREADY_EXISTS:
    case Error::OUT_OF_RANGE:
      return kInvalid;
    case Error::UNAVAILABLE:
      return kUnreachable;
    case Error::RESOURCE_EXHAUSTED:
    case Error::ABORTED:
      return kBusy;
    case Error::PERMISSION_DENIED:
    case Error::UNAUTHENTICATED:
      return kDenied;
    default:
      return kFailed;
  }
}

Error to_detail(const ErrorInfo& info) {
  Error error;
  error.set_code(code_of(info.kind));
  error.set_reason(info.reason);
  error.set_message(info.message);
  error.set_stage(info.stage);
  error.set_feature(info.feature);
  error.set_parameter(info.parameter);
  error.set_hint(info.hint);
  if (info.edit_index) error.set_edit_index(static_cast<std::uint32_t>(*info.edit_index));
  if (info.retry_after) error.set_retry_after(*info.retry_after);
  return error;
}

Error to_detail(const DocumentErrorInfo& info) {
  return to_detail(ErrorInfo{.kind = ErrorKind::InvalidArgument,
                             .reason = info.reason,
                             .message = info.message,
                             .stage = "document",
                             .feature = info.feature,
                             .parameter = info.parameter,
                             .hint = info.hint,
                             .edit_index = info.edit_index});
}

}  // namespace remeshd::cli
