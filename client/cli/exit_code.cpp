#include "client/cli/exit_code.h"

#include <algorithm>
#include <array>
#include <string>

namespace remeshd::cli {
namespace {

using remesh::v1::Error;

/// Reasons that call for another exit code than their error's code does.
struct ReasonExit {
  Error::Reason reason;
  ExitCode exit;
};

constexpr std::array kByReason{
    // The model's own fault, although it shows only while the model is built.
    ReasonExit{Error::EMPTY_MODEL, kInvalid},
    ReasonExit{Error::DISCONNECTED_MODEL, kInvalid},
    ReasonExit{Error::NON_MANIFOLD_MODEL, kInvalid},
    // The request names what it may not.
    ReasonExit{Error::HEAD_PROTECTED, kInvalid},
    ReasonExit{Error::REVISION_OUTDATED, kInvalid},
    ReasonExit{Error::DESIGN_ELSEWHERE, kInvalid},
    ReasonExit{Error::DOCUMENT_UNREADABLE, kFileFailed},
    // The store of `--local`, or of the daemon.
    ReasonExit{Error::STORE_LOCKED, kBusy},
    ReasonExit{Error::STORE_FOREIGN, kFileFailed},
    ReasonExit{Error::STORE_NEWER, kFileFailed},
    ReasonExit{Error::STORE_FAILED, kFileFailed},
    ReasonExit{Error::STORE_CORRUPTED, kFileFailed},
};

/// What gRPC itself says of a message over the daemon's limit, which a document in it caused.
bool is_oversized(const Error& error) {
  return error.code() == Error::CODE_RESOURCE_EXHAUSTED &&
         error.reason() == Error::REASON_UNSPECIFIED &&
         error.message().find("larger than max") != std::string::npos;
}

Error::Code code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::InvalidArgument:
      return Error::CODE_INVALID_ARGUMENT;
    case ErrorKind::NotFound:
      return Error::CODE_NOT_FOUND;
    case ErrorKind::FailedPrecondition:
      return Error::CODE_FAILED_PRECONDITION;
    case ErrorKind::DeadlineExceeded:
      return Error::CODE_DEADLINE_EXCEEDED;
    case ErrorKind::ResourceExhausted:
      return Error::CODE_RESOURCE_EXHAUSTED;
    case ErrorKind::Aborted:
      return Error::CODE_ABORTED;
    case ErrorKind::Cancelled:
      return Error::CODE_CANCELLED;
    case ErrorKind::Unavailable:
      return Error::CODE_UNAVAILABLE;
    case ErrorKind::Internal:
      return Error::CODE_INTERNAL;
    case ErrorKind::DataLoss:
      return Error::CODE_DATA_LOSS;
    case ErrorKind::Unimplemented:
      return Error::CODE_UNIMPLEMENTED;
    case ErrorKind::PermissionDenied:
      return Error::CODE_PERMISSION_DENIED;
    case ErrorKind::Unauthenticated:
      return Error::CODE_UNAUTHENTICATED;
  }
  return Error::CODE_UNKNOWN;
}

Error::Reason reason_of(const std::string& name) {
  Error::Reason reason = Error::REASON_UNSPECIFIED;
  Error::Reason_Parse(name, &reason);
  return reason;
}

}  // namespace

ExitCode exit_code(const Error& error) {
  const auto* special = std::ranges::find(kByReason, error.reason(), &ReasonExit::reason);
  if (special != kByReason.end()) return special->exit;
  if (is_oversized(error)) return kInvalid;
  switch (error.code()) {
    case Error::CODE_INVALID_ARGUMENT:
    case Error::CODE_NOT_FOUND:
    case Error::CODE_ALREADY_EXISTS:
    case Error::CODE_OUT_OF_RANGE:
    case Error::CODE_UNIMPLEMENTED:  // asks for what the daemon does not do
      return kInvalid;
    case Error::CODE_DATA_LOSS:
      return kFileFailed;
    case Error::CODE_UNAVAILABLE:
      return kUnreachable;
    case Error::CODE_RESOURCE_EXHAUSTED:
    case Error::CODE_ABORTED:
      return kBusy;
    case Error::CODE_PERMISSION_DENIED:
    case Error::CODE_UNAUTHENTICATED:
      return kDenied;
    default:
      return kFailed;
  }
}

Error to_detail(const ErrorInfo& info) {
  Error error;
  error.set_code(code_of(info.kind));
  error.set_reason(reason_of(info.reason));
  error.set_message(info.message);
  error.set_stage(info.stage);
  for (const std::string& feature : info.features) error.add_features(feature);
  error.set_parameter(info.parameter);
  error.set_hint(info.hint);
  for (const std::string& attempt : info.attempts) error.add_attempts(attempt);
  if (info.edit_index) error.set_edit_index(static_cast<std::uint32_t>(*info.edit_index));
  if (info.retry_after) error.set_retry_after(*info.retry_after);
  return error;
}

Error to_detail(const DocumentErrorInfo& info) {
  Error error;
  error.set_code(Error::CODE_INVALID_ARGUMENT);
  error.set_reason(reason_of(info.reason));
  error.set_message(info.message);
  error.set_stage("document");
  if (!info.feature.empty()) error.add_features(info.feature);
  error.set_parameter(info.parameter);
  error.set_hint(info.hint);
  if (info.edit_index) error.set_edit_index(static_cast<std::uint32_t>(*info.edit_index));
  if (info.at.line > 0) error.set_line(info.at.line);
  if (info.at.column > 0) error.set_column(info.at.column);
  return error;
}

}  // namespace remeshd::cli
