#pragma once

#include <vector>

#include "engine/kernel/delaunay.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// Keeps the Delaunay mesh of the fixed nodes and completes it, iteration after iteration, with the
/// free ones where they are now.
class Triangulator {
 public:
  /// `holds`: by node, whether `mesh` has it already; such nodes are fixed.
  Triangulator(const NodeSet& nodes, kernel::Delaunay mesh, std::vector<std::uint8_t> holds,
               const Run& run);

  /// Brings the mesh of the fixed nodes up to the present sets: nodes freed since are taken out,
  /// nodes fixed since are put in.
  void update(const NodeSet& nodes);

  /// The Delaunay mesh of all nodes.
  [[nodiscard]] kernel::Delaunay complete(const NodeSet& nodes) const;

 private:
  const kernel::Delaunay empty_;
  kernel::Delaunay fixed_;
  std::vector<std::uint8_t> holds_;
  const Run& run_;
};

/// All tets but those at the far corners.
std::vector<Tet> tets_of(const kernel::Delaunay& mesh);

}  // namespace remeshd
