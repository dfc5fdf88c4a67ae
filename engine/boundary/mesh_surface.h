#pragma once

#include <cstddef>

#include "engine/base/run.h"
#include "engine/boundary/surface_mesh.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

struct SurfaceMeshOptions {
  SizeField sizes{0};  ///< target length of sides
  double share = 1;    ///< sides are `share` x as long as `sizes` says
  /// x `share` x the least edge length of `sizes`: neither thin faces nor the curvature of cones
  /// and tori ask for shorter sides than this.
  double least_length = 0.125;
  std::size_t most_facets = 300'000;  ///< a surface that would need more is refused
  /// Rounds of local refinement where facets of near faces cut each other.
  int crossing_rounds = 8;
};

/// Meshes the boundary with triangles of about the target length: the triangulation of the faces
/// remeshed, all nodes on their exact faces and edges. Sides are shorter where a face or an edge
/// curves too much for them, across and beside thin faces and short model edges, and where facets
/// would cut others; lengths vary gradually.
///
/// Post: what SurfaceMesh promises. Facets that cut each other may be left where rounds run out.
/// Throws what tessellated_surface throws; Error(TETGEN_REFUSED) above `most_facets`; Cancelled.
SurfaceMesh mesh_surface(const BoundaryModel& boundary, const SurfaceMeshOptions& options,
                         const Run& run);

}  // namespace remeshd
