#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/run.h"
#include "engine/revision/revision.h"
#include "engine/second_order/mid_numbers.h"

namespace remeshd {

/// A mid-node that is to lie on the model's boundary, off the middle of its corner nodes.
struct CurvedEdge {
  std::int32_t mid;
  Vec3 place;
};

/// Finds the mesh edges on curved faces and edges of the model, with the places of their mid-nodes:
/// the point nearest to the middle of the corner nodes, on the model edge's curve, else on the face
/// that both facets are on. Ascending by mid-node.
///
/// `revision`: with its output mesh and the boundary that it is a mesh of.
std::vector<CurvedEdge> curved_edges(const Revision& revision, const MidNumbers& numbers,
                                     const Run& run);

}  // namespace remeshd
