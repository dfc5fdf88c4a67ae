#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/cow_vector.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// A revision's mesh as an edit copies it, on the boundary of `Revision::copied_model()`.
struct CopiedMesh {
  const DelaunayState& delaunay_state;
  const CowVector<Support>& supports;  ///< of the nodes, in the boundary of the revision's cells
  PagedMesh output;                    ///< the nodes are `Revision::copied_nodes()`
  /// By node: its position before clean-up. That is its position in `delaunay_state`, moved along
  /// for nodes that have followed surfaces since the Delaunay mesh was made.
  CowVector<Vec3> positions;
  std::vector<std::int32_t> followed;  ///< nodes that have followed surfaces, ascending
};

/// Keeps references to the revision.
CopiedMesh copied_mesh(const Revision& revision);

}  // namespace remeshd
