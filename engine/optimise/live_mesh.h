#pragma once

#include <vector>

#include "engine/kernel/delaunay.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// The Delaunay mesh of a NodeSet, kept up with its nodes while they move and increase.
class LiveMesh {
 public:
  /// `holds`: by node, whether `start` has it already, where it is now.
  LiveMesh(const NodeSet& nodes, kernel::Delaunay start, const std::vector<std::uint8_t>& holds,
           const Run& run);

  /// Brings the mesh up to where the nodes are now; new nodes come last in the set.
  void follow(const NodeSet& nodes);

  [[nodiscard]] const kernel::Delaunay& mesh() const { return mesh_; }
  /// All tets but those at the far corners.
  [[nodiscard]] std::vector<Tet> tets() const;

 private:
  kernel::Delaunay mesh_;
  std::int32_t count_ = 0;  ///< nodes in it
  const Run& run_;
};

}  // namespace remeshd
