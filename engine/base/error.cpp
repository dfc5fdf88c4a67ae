#include "engine/base/error.h"

namespace remeshd::error {

Error cancelled() {
  return Error({.kind = ErrorKind::Cancelled,
                .reason = "Cancelled",
                .message = "the call was cancelled",
                .stage = "request"});
}

Error internal(std::string_view stage, std::string_view what) {
  return Error({.kind = ErrorKind::Internal,
                .reason = "Internal",
                .message = std::string(what),
                .stage = std::string(stage)});
}

}  // namespace remeshd::error
