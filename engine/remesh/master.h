#pragma once

#include <cstdint>
#include <vector>

#include "engine/cellular/support.h"
#include "engine/kernel/delaunay.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// The Delaunay mesh that a revision's delivered mesh was cleaned up from, and that the next edit
/// copies its nodes from. Node i of the master is node i of the delivered mesh.
struct Master {
  std::vector<Vec3> positions;
  std::vector<Support> supports;   ///< entities of the revision's BoundaryModel
  kernel::Delaunay mesh;           ///< of all nodes, the outside included
  std::vector<Tet> tets;           ///< peeled: inside the model
  std::uint64_t next_node_id = 1;  ///< permanent ids below are taken along the chain of ancestors
  std::uint64_t next_tet_id = 1;
};

}  // namespace remeshd
