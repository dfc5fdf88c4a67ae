#pragma once

#include <span>

#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/plan/copy_plan.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// The original mesh as the copying sees it: Delaunay mesh positions, where each node stood on
/// the original boundary, and the tets of the model.
struct OriginalNodes {
  const CowVector<Vec3>& positions;
  const CowVector<Support>& supports;  ///< in the original boundary; copies keep them
  /// Nodes that are looked at, ascending. All others are where nothing changed.
  std::span<const std::int32_t> near;
  std::span<const Tet> tets;  ///< of the peeled mesh: all that have such a node
};

/// Copies the nodes of the original mesh to the copycells (Sect. 6.4), each at most once, with the
/// transformation of the feature whose copycells it falls in. A boundary node is copied if the
/// material next to it, in one of its tets, is copied: so a node on the cap of a hole that moved
/// onto old material does not come along.
///
/// A node that would end up outside while the material of its tets is copied, as on the wall of a
/// hole that grew a little, is set back to the new boundary as a free node. Of such nodes as many
/// are left out as the lost volume held: else the density of nodes would drift along a chain of
/// small edits.
///
/// `sizes`: target edge lengths of the original mesh.
/// Post: every node is the copy of one near the change, fixed but for those set back; supports are
/// interior or, for nodes that were on the boundary, still those of the original.
CopiedNodes copy_nodes(const CopyPlan& plan, const OriginalNodes& original, const SizeField& sizes,
                       const Run& run);

}  // namespace remeshd
