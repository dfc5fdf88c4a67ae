#pragma once

#include <vector>

#include "engine/local_fuse/arrangement/sectors.h"

namespace remeshd {

/// An edge of a general fuse of patches: a part of a curve between two of its nodes.
struct PrismEdge {
  int curve = -1;
  double from = 0, to = 0;  ///< parameters, ascending
  int a = -1, b = -1;       ///< nodes; equal for a closed edge
  double seen_at = 0;       ///< parameter of the point round which `half_faces` lie
  std::vector<HalfFace> half_faces;
};

struct PrismEdges {
  std::vector<Vec3> nodes;
  std::vector<PrismEdge> edges;
};

/// The edges of a general fuse, seams included: the parts of the curves where faces end. An edge
/// goes on along its curve as long as the half-faces round it stay the same and no other edge ends
/// on it.
///
/// Gives up where the half-faces are in doubt, where two nodes are neither clearly the same nor
/// clearly apart, or where an edge is very short.
Tried<PrismEdges> find_prism_edges(const std::vector<IntersectionCurve>& curves,
                                   const Sectors& sectors, const Clearance& clearance);

}  // namespace remeshd
