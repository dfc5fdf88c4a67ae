#pragma once

#include <optional>

#include "engine/model/solid.h"

namespace remeshd {

/// A point, off all edges and vertices, at which the boundary touches itself, if there is one; the
/// topology of the cells does not show it. There a sphere is tangent to a surface of another
/// feature, to within `tolerance`, with material between the two and none beyond, or vice versa.
///
/// Not looked for: point contacts without a sphere, as of two crossing cylinders.
std::optional<Vec3> find_point_contact(const Membership& membership, double tolerance);

}  // namespace remeshd
