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
  /// Of the nodes of the Delaunay mesh, where clean-up has not moved them: those of
  /// `delaunay_state`, but for the nodes that have followed surfaces since it was made.
  CowVector<Vec3> positions;
  std::vector<std::int32_t> followed;  ///< these nodes, ascending
};

/// Keeps references to the revision.
CopiedMesh copied_mesh(const Revision& revision);

}  // namespace remeshd
