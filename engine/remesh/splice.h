#pragma once

#include <span>
#include <vector>

#include "engine/remesh/carry_over.h"
#include "engine/remesh/part.h"
#include "engine/remesh/remesh.h"

namespace remeshd {

/// What came of the nodes of a part.
struct PartMesh {
  const NodeSet& nodes;
  const kernel::Delaunay& delaunay;  ///< of all nodes
  const PeeledMesh& peeled;          ///< its tets in the model
  const TetMesh& mesh;               ///< cleaned up
  const SameTets& same;              ///< by tet of `mesh`; empty where nothing is known
};

/// A whole mesh with where it came from.
struct WholeMesh {
  PagedMesh mesh;
  Master master;  ///< but for permanent ids
  NodeMap map;
  std::vector<std::int32_t> new_tets;  ///< by tet of the part's mesh: its number
};

/// A mesh whose nodes and tets are all new: the nodes as they stand in the part, tets in the order
/// of their lowest nodes.
WholeMesh whole_mesh(const PartMesh& part, const Run& run);

/// Puts a part's mesh back in the place of what was cut out. Copies keep the number of their
/// original, tets that stayed theirs; others take the numbers of those that went, lowest first,
/// then go to the end; where more went than came, the last ones fill the gaps.
///
/// `supports`: of the original's nodes, in the modified boundary; those in the part are not read.
WholeMesh splice(const Revision& original, Pages<Support> supports, const OriginalPart& cut,
                 const PartMesh& part, const PointSource& source, const Run& run);

}  // namespace remeshd
