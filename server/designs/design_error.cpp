#include "server/designs/design_error.h"

#include <string>

namespace remeshd::error {

Error catalogue_unavailable(std::string_view why) {
  return Error({.kind = ErrorKind::Unavailable,
                .reason = "CATALOGUE_UNAVAILABLE",
                .message = "the database that has the designs cannot be used: " + std::string(why),
                .stage = "store",
                .hint = "try again later; what is named by its id, and filed in no design, goes on",
                .retry_after = 1});
}

Error design_elsewhere(std::string_view design, std::string_view home) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "DESIGN_ELSEWHERE",
                .message = "the names of the design `" + std::string(design) +
                           "` are at the replica " + std::string(home),
                .stage = "request",
                .hint = "ask that one, or name revisions by their ids",
                .home = std::string(home)});
}

}  // namespace remeshd::error
