#pragma once

#include <cmath>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd::test {

/// A face in the plane through the y axis that rises along x by an angle, 10 by 10, moved up by
/// `height`; its outward normal looks up, or down.
inline BoundaryFace square_face(double angle, double height, bool looks_up) {
  const Vec3 x{std::cos(angle), 0, std::sin(angle)}, y{0, 1, 0}, origin{0, 0, height};
  BoundaryFace face;
  face.surface.frame = Transform::frame(x, y, cross(x, y), origin);
  face.reversed = !looks_up;
  face.points = {origin, origin + 10 * x, origin + 10 * x + 10 * y, origin + 10 * y};
  face.triangles = {{0, 1, 2}, {0, 2, 3}};
  return face;
}

}  // namespace remeshd::test
