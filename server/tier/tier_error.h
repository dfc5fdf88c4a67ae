#pragma once

#include <cstddef>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

/// The shared tier cannot be reached or fails, because `why`; `retry_after`: s until it should be
/// asked again.
Error tier_unavailable(std::string_view why, double retry_after);
/// The shared tier answers, but refuses an object of `bytes` bytes with the HTTP status `status`;
/// to try again is useless.
Error tier_refused(std::size_t bytes, long status);

}  // namespace remeshd::error
