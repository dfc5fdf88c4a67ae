#pragma once

#include <string>
#include <string_view>

namespace remeshd::kernel {

/// What OpenCASCADE writes, easier to read and as ISO 10303-21 has it: a line an entity, numbers
/// without the zeros behind their last digit, characters beyond ASCII as `\X2\00E9\X0\`.
std::string tidy_exchange_text(std::string_view text);

}  // namespace remeshd::kernel
