#pragma once

#include <vector>

#include "engine/local_fuse/arrangement/sectors.h"

namespace remeshd {

/// An edge of a general fuse of patches: a part of a curve between two of its nodes.
struct PrismEdge {
  int curve = -1;
  double from = 0, to = 0;  ///< parameters, ascending
  int a = -1, b = -1;       ///< nodes; the same of a closed one
  double seen_at = 0;       ///< parameter of the half-faces' directions
  std::vector<HalfFace> half_faces;
};

struct PrismEdges {
  std::vector<Vec3> nodes;
  std::vector<PrismEdge> edges;
};

/// The parts of curves where faces of a general fuse end, seams too, each as long as what lies
/// round it stays the same and no other edge ends at it.
///
/// Gives up where that is in doubt.
Tried<PrismEdges> find_prism_edges(const std::vector<IntersectionCurve>& curves,
                                   const Sectors& sectors, const Clearance& clearance);

}  // namespace remeshd
