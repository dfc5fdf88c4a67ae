#pragma once

#include <string>

#include "tests/campaign/draft.h"

namespace remeshd::campaign {

/// Adds a feature of any kind, turned and placed at random near a place of the part, and returns
/// its id. `r`: radius of what carries it; `depth`: of the material below; `l`: target edge length.
std::string add_any_feature(Draft& d, const Transform& frame, double r, double depth, double l);

}  // namespace remeshd::campaign
