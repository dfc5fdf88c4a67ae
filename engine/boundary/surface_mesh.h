#pragma once

#include <array>
#include <vector>

#include "engine/cellular/boundary_model/support.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// A facet of a model face; `edge[i]` is the model edge that its side from nodes[i] to the next
/// node runs along, -1 where that side lies within the face.
struct FaceFacet {
  Triangle nodes;  ///< outward
  std::array<std::int32_t, 3> edge{-1, -1, -1};
  std::int32_t face = -1;
};

/// A mesh of the model's boundary: closed, every node on the model vertex, edge or face that its
/// support names, every model edge a chain of sides.
struct SurfaceMesh {
  std::vector<Vec3> nodes;
  std::vector<Support> supports;
  std::vector<FaceFacet> facets;
};

/// The triangulations of all faces as one surface mesh.
///
/// Throws Error(KERNEL_FAILURE) where they do not meet along the model's edges.
SurfaceMesh tessellated_surface(const BoundaryModel& boundary);

}  // namespace remeshd
