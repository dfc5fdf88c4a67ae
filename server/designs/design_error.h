#pragma once

#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

/// The database that has the designs cannot be reached or fails, because `why`.
Error catalogue_unavailable(std::string_view why);
/// The design's home (`Homes`) is another replica, which clients reach by the address `home`.
Error design_elsewhere(std::string_view design, std::string_view home);

}  // namespace remeshd::error
