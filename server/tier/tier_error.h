#pragma once

#include <cstddef>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd {

/// TIER_UNAVAILABLE, because no answer came in time.
class TierTimeout : public Error {
  using Error::Error;
};

namespace error {

/// The shared tier cannot be reached or fails, because `why`; `retry_after`: s until it should be
/// asked again.
Error tier_unavailable(std::string_view why, double retry_after);
TierTimeout tier_timed_out(std::string_view why, double retry_after);
/// The shared tier answers, but refuses an object of `bytes` bytes with the HTTP status `status`;
/// to try again is useless.
Error tier_refused(std::size_t bytes, long status);

}  // namespace error
}  // namespace remeshd
