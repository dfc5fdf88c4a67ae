#pragma once

#include <cstddef>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

/// The shared tier cannot be reached or fails, because `why`; to be asked again after so many
/// seconds.
Error tier_unavailable(std::string_view why, double retry_after);
/// It answers, and takes no object of so many bytes, with that HTTP status; to try again is
/// useless.
Error tier_refused(std::size_t bytes, long status);

}  // namespace remeshd::error
