#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// The name that differs from `name` by the fewest letters (added, left out, replaced, swapped with
/// the next), upper and lower case, `-` and `_` being alike. Empty where none is similar.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);

/// `; did you mean X?`, or empty.
std::string suggestion(std::string_view name, const std::vector<std::string>& names);

}  // namespace remeshd
