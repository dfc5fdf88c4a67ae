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

/// Mesh edges on curved faces and edges of the model, and the points of these between their corner
/// nodes: on a model edge's curve, the point nearest to the middle; else on the face of both
/// facets. Ascending by mid-node.
///
/// `revision`: with its output mesh and the boundary that it is a mesh of.
std::vector<CurvedEdge> curved_edges(const Revision& revision, const MidNumbers& numbers,
                                     const Run& run);

}  // namespace remeshd
