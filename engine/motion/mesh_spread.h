#pragma once

#include <span>
#include <vector>

#include "engine/motion/spread.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Carries the motion of a model's boundary into all of a mesh: from the model's vertices along its
/// edges, from there over its faces, and from all of the boundary into the interior. Each time the
/// mesh is stretched least (`Spread`), and a node on an edge or face stays on it.
class MeshSpread {
 public:
  /// `revision`: the mesh's connectivity, and the boundary that its supports stand on; `nodes`:
  /// where its nodes are.
  MeshSpread(const Revision& revision, const CowVector<Vec3>& nodes, const Run& run);

  [[nodiscard]] const Spread& edges() const { return edges_; }
  [[nodiscard]] const Spread& faces() const { return faces_; }
  [[nodiscard]] const Spread& interior() const { return interior_; }

  /// Motions of all nodes. `motions`: by node; a node at a vertex moves by `required`.
  [[nodiscard]] std::vector<Vec3> forward(std::span<const NodeMotion> motions,
                                          const Run& run) const;
  /// The transpose: from d J / d motion of all nodes to d J / d required; nought in the interior.
  [[nodiscard]] std::vector<Vec3> reverse(std::span<const NodeMotion> motions,
                                          std::vector<Vec3> seed, const Run& run) const;

 private:
  Spread edges_, faces_, interior_;
};

}  // namespace remeshd
