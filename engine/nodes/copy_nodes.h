#pragma once

#include <span>
#include <vector>

#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/plan/point_source.h"

namespace remeshd {

/// The original mesh as the copying sees it: Delaunay master positions, where each node stood on
/// the original boundary, and the tets of the model.
struct OriginalNodes {
  std::span<const Vec3> positions;
  std::span<const Support> supports;  ///< entities of the original boundary; only the kind is used
  std::span<const Tet> tets;          ///< peeled: inside the original model
};

/// Copies the nodes of the original mesh to the copycells (Sect. 6.4), each at most once, with the
/// transformation of the feature whose copycells it falls in. A boundary node is copied if the
/// material next to it, in one of its tets, is copied: so a node on the cap of a hole that moved
/// onto old material does not come along.
///
/// Post: every node is a fixed copy; supports are interior or, for nodes that were on the boundary,
/// still those of the original.
NodeSet copy_nodes(const PointSource& source, const OriginalNodes& original, const Run& run);

}  // namespace remeshd
