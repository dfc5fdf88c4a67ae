#pragma once

#include <optional>
#include <vector>

#include "engine/cellular/wedges.h"

namespace remeshd {

/// An edge of a general fuse of patches: a part of a carrier between two of its nodes.
struct CrossedEdge {
  int carrier = -1;
  double from = 0, to = 0;  ///< parameters, ascending
  int a = -1, b = -1;       ///< nodes; the same of a closed one
  double seen_at = 0;       ///< parameter of the sheets' directions
  std::vector<Sheet> sheets;
};

struct CrossedEdges {
  std::vector<Vec3> nodes;
  std::vector<CrossedEdge> edges;
};

/// The parts of carriers where faces of a general fuse end, seams too, each as long as what lies
/// round it stays the same and no other edge ends at it.
///
/// Returns nothing where that is in doubt.
std::optional<CrossedEdges> find_crossed_edges(const std::vector<Carrier>& carriers,
                                               const Wedges& wedges, const Clearance& clearance);

}  // namespace remeshd
