#pragma once

#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

/// The shared tier cannot be reached or fails, because `why`; to be asked again after so many
/// seconds.
Error tier_unavailable(std::string_view why, double retry_after);

}  // namespace remeshd::error
