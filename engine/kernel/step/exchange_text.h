#pragma once

#include <string>
#include <string_view>

namespace remeshd::kernel {

/// Makes the STEP text that OpenCASCADE writes easier to read and conform to ISO 10303-21: one
/// entity a line, numbers without trailing zeros, characters beyond ASCII as `\X2\00E9\X0\`.
std::string tidy_exchange_text(std::string_view text);

}  // namespace remeshd::kernel
