#pragma once

#include <array>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// Square of the distance of p to a triangle.
double triangle_distance2(const Vec3& p, const std::array<Vec3, 3>& corners);

/// Squared distance of p from the triangulation of a face.
double face_distance2(const BoundaryFace& face, const Vec3& p);

}  // namespace remeshd
