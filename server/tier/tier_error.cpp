#include "server/tier/tier_error.h"

#include <string>

namespace remeshd::error {

Error tier_unavailable(std::string_view why, double retry_after) {
  return Error({.kind = ErrorKind::Unavailable,
                .reason = "TIER_UNAVAILABLE",
                .message = "the shared tier cannot be used: " + std::string(why),
                .stage = "store",
                .hint = "try again later; the daemon's log tells when it answers again",
                .retry_after = retry_after});
}

TierTimeout tier_timed_out(std::string_view why, double retry_after) {
  return TierTimeout(tier_unavailable(why, retry_after).info());
}

Error tier_refused(std::size_t bytes, long status) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "TIER_REFUSED",
                .message = "the shared tier refuses an object of " + std::to_string(bytes) +
                           " bytes, with status " + std::to_string(status),
                .stage = "store",
                .hint = "raise the tier's limit on the size of objects"});
}

}  // namespace remeshd::error
