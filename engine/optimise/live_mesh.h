#pragma once

#include <cstdint>
#include <vector>

#include "engine/delaunay/delaunay_mesh.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// Thrown where a change of a patch's mesh would have to go on beyond the patch's interface: the
/// patch is too small.
struct PatchTooSmall {
  const char* where;  ///< the step that was under way
};

/// The Delaunay mesh of a NodeSet, updated as its nodes move and nodes are added.
class LiveMesh {
 public:
  /// `holds`: by node, 1 where `start` has it already; `follow` inserts the others. `rebuild`: each
  /// `follow` builds the mesh anew from `start` less the nodes that moved, as in the paper.
  LiveMesh(DelaunayMesh start, std::vector<std::uint8_t> holds, bool rebuild, const Run& run);

  /// Makes the mesh that of all nodes at their present positions. Throws PatchTooSmall.
  /// Pre: nodes added since the last call come last in the set.
  void follow(const NodeSet& nodes);

  [[nodiscard]] const DelaunayMesh& mesh() const { return mesh_; }
  /// All tets but those at the super vertices.
  [[nodiscard]] std::vector<Tet> tets() const;
  /// Those of `tets()` that have a node with a 1 in `at`, which is by node.
  [[nodiscard]] std::vector<Tet> tets_at(const std::vector<std::uint8_t>& at) const;

 private:
  /// Moves `held`, the nodes that `mesh_` has, to their positions. Returns false where that cannot
  /// be done or costs more than a restart; `mesh_` must then not be used any more.
  bool follow_held(const NodeSet& nodes, const std::vector<std::int32_t>& held);
  void restart(const NodeSet& nodes);
  void require_patch() const;

  DelaunayMesh mesh_;
  DelaunayMesh base_;                  ///< `start` less what has moved: `mesh_` restarts from it
  std::vector<std::uint8_t> holds_;    ///< by node: whether `mesh_` has it
  std::vector<std::uint8_t> in_base_;  ///< by node: whether `base_` has it
  bool rebuild_;
  const Run& run_;
};

}  // namespace remeshd
