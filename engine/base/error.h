#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace remeshd {

/// What kind of failure an Error is; the server maps each to one gRPC status.
enum class ErrorKind {
  InvalidArgument,     ///< the request cannot be right whatever the state
  NotFound,            ///< no such revision, design or feature
  FailedPrecondition,  ///< the request is sound, this model cannot be meshed or this state forbids it
  DeadlineExceeded,
  ResourceExhausted,  ///< busy or too big; may carry a retry delay
  Aborted,            ///< lost a compare-and-set
  Cancelled,
  Internal,
};

/// A failure a user can act on: what, where in the run, which feature and parameter, what to do.
struct ErrorInfo {
  ErrorKind kind = ErrorKind::Internal;
  std::string reason;     ///< stable CamelCase name, e.g. `DegenerateFeature`
  std::string message;    ///< one sentence
  std::string stage;      ///< station of the engine or `request`
  std::string feature;    ///< feature id, empty if none
  std::string parameter;  ///< parameter, `placement.origin[1]`, `profile[3]`, ...; empty if none
  std::string hint;       ///< what would help; empty if nothing sensible can be said
  std::optional<int> edit_index;      ///< 0-based index of the edit at fault
  std::optional<double> retry_after;  ///< s, with ResourceExhausted
};

class Error : public std::runtime_error {
 public:
  explicit Error(ErrorInfo info) : std::runtime_error(info.message), info_(std::move(info)) {}
  [[nodiscard]] const ErrorInfo& info() const { return info_; }
  ErrorInfo& info() { return info_; }

 private:
  ErrorInfo info_;
};

/// One function per failure; each returns the Error to throw.
namespace error {

Error cancelled();
Error internal(std::string_view stage, std::string_view what);

}  // namespace error
}  // namespace remeshd
