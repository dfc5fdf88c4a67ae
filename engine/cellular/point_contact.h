#pragma once

#include <optional>

#include "engine/model/solid.h"

namespace remeshd {

/// Where the boundary touches itself at a single point off all its edges and vertices, so that the
/// cells do not tell: a sphere and any other surface that is tangent to it, with material between
/// and none beyond, or the other way round. Tangency to within `tolerance`.
///
/// Not looked for: point contacts without a sphere, as of two crossing cylinders.
std::optional<Vec3> find_point_contact(const Membership& membership, double tolerance);

}  // namespace remeshd
