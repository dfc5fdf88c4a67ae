#pragma once

#include "engine/base/vec.h"

namespace remeshd {

/// The circumcentre of the tet with corners at the origin, a, b and c; not finite where the four
/// are coplanar.
inline Vec3 to_circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 bc = cross(b, c);
  return (1 / (2 * dot(a, bc))) * (norm2(a) * bc + norm2(b) * cross(c, a) + norm2(c) * cross(a, b));
}

}  // namespace remeshd
