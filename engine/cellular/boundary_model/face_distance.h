#pragma once

#include <array>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// The point of a triangle that is nearest to p.
Vec3 nearest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& corners);

/// Square of the distance of p to a triangle.
double triangle_distance2(const Vec3& p, const std::array<Vec3, 3>& corners);

/// Squared distance of p from the triangulation of a face.
double face_distance2(const BoundaryFace& face, const Vec3& p);

}  // namespace remeshd
