#pragma once

#include <cstdint>
#include <vector>

#include "engine/delaunay/delaunay_mesh.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// A change had to go on beyond the interface of the patch that it was worked on in: the patch was
/// too small.
struct PatchTooSmall {
  const char* where;  ///< what was under way
};

/// The Delaunay mesh of a NodeSet, kept up with its nodes while they move and increase.
class LiveMesh {
 public:
  /// `holds`: by node, 1 where `start` has it already. The others follow. `rebuild`: the mesh is
  /// built from `start` each time, whatever has moved.
  LiveMesh(DelaunayMesh start, std::vector<std::uint8_t> holds, bool rebuild, const Run& run);

  /// Brings the mesh up to the nodes, all of them, where they are now; new nodes come last in the
  /// set. Throws PatchTooSmall.
  void follow(const NodeSet& nodes);

  [[nodiscard]] const DelaunayMesh& mesh() const { return mesh_; }
  /// All tets but those at the super vertices.
  [[nodiscard]] std::vector<Tet> tets() const;
  /// Those of them with a node that has a 1 in `at`, by node.
  [[nodiscard]] std::vector<Tet> tets_at(const std::vector<std::uint8_t>& at) const;

 private:
  /// Returns false if the mesh is not to be used any more.
  bool follow_held(const NodeSet& nodes, const std::vector<std::int32_t>& held);
  void restart(const NodeSet& nodes);
  void require_patch() const;

  DelaunayMesh mesh_;
  DelaunayMesh base_;                  ///< of the fixed nodes: `mesh_` restarts from it
  std::vector<std::uint8_t> holds_;    ///< by node: whether `mesh_` has it
  std::vector<std::uint8_t> in_base_;  ///< by node: whether `base_` has it
  bool rebuild_;
  const Run& run_;
};

}  // namespace remeshd
