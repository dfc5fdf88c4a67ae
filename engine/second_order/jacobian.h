#pragma once

#include <array>

#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// A tet of second order: corners, and a node on each edge, in the order of `kTetEdges`.
struct QuadraticTet {
  std::array<Vec3, 4> corners;
  std::array<Vec3, 6> mids;
};

/// A lower bound of the Jacobian determinant of the map from the reference tet of volume 1/6, as a
/// share of what it is with straight edges: 1 where they are, positive only where the map is
/// invertible everywhere.
///
/// The determinant is a cubic polynomial, which is nowhere less than the least of its 20 Bezier
/// coefficients: Johnen, Remacle, Geuzaine, Geometrical validity of curvilinear finite elements,
/// Journal of Computational Physics 233 (2013), Sect. 3.
double least_jacobian(const QuadraticTet& tet);

}  // namespace remeshd
