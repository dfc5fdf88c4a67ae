#pragma once

#include "engine/base/vec.h"

namespace remeshd::campaign {

/// Sign of dot(cross(b - a, c - a), d - a): +1 for a positive tet, 0 for a flat one. Exact, by
/// rational numbers where floating point cannot tell.
int volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace remeshd::campaign
