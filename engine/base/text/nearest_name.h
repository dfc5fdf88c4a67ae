#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// The name that differs from `name` by the fewest letters (added, left out, replaced, or swapped
/// with the next one). Only ASCII letters and digits are compared, regardless of case; `-`, `_` and
/// all else is left out first. Empty where no name is similar.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);

/// `; did you mean X?`, or empty.
std::string suggestion(std::string_view name, const std::vector<std::string>& names);

}  // namespace remeshd
