#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// Squared distance of p from the triangulation of a face.
double face_distance2(const BoundaryFace& face, const Vec3& p);

}  // namespace remeshd
