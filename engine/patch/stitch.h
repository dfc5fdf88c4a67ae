#pragma once

#include <vector>

#include "engine/patch/patch.h"
#include "engine/patch/reuse_improved_tets.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// The mesh that was made of a patch's nodes, to be put back.
struct PatchMesh {
  const NodeSet& nodes;
  const DelaunayMesh& delaunay;  ///< of all nodes
  const PeeledMesh& peeled;      ///< its tets in the model
  const TetMesh& mesh;           ///< cleaned up
  const SameTets& same;          ///< by tet of `mesh`; empty where nothing is known
  CavityExtent cavities = CavityExtent::Connected;  ///< how to find its cavities
};

/// A whole mesh with where it came from.
struct StitchedMesh {
  PagedMesh mesh;
  DelaunayState delaunay_state;  ///< but for permanent ids
  NodeMap map;
  std::vector<std::int32_t> new_tets;  ///< by tet of the patch's mesh: its number in `mesh`
};

/// Puts a patch's mesh back in the place of what was cut out. Copied nodes keep the number of their
/// original, and tets that stayed keep theirs. New nodes and tets take the numbers of removed ones,
/// lowest first, then numbers at the end. Where more were removed than added, the last nodes or
/// tets of the mesh are renumbered to fill the gaps. Where nothing was cut out, tets are numbered
/// in the order of their lowest nodes.
///
/// `supports`: of the original's nodes, in the modified boundary; those in the patch are not read.
StitchedMesh stitch(const Revision& original, CowVector<Support> supports, const MeshPatch& cut,
                    const PatchMesh& patch, const CopyPlan& plan, const Run& run);

}  // namespace remeshd
