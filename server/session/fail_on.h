#pragma once

#include <span>

#include "engine/base/warning.h"

namespace remeshd {

/// Throws Error(WARNING_IS_ERROR) for the first of the warnings that has one of these codes.
void check_warnings(std::span<const Warning> warnings, std::span<const WarningCode> fail_on);

}  // namespace remeshd
