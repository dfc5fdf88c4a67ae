#pragma once

#include <vector>

#include "engine/kernel/brep.h"
#include "engine/local_fuse/arrangement/slabs.h"

namespace remeshd {

/// Makes the vertices and edges of what is swept, when faces ask for them: level ones, on a piece
/// of the outlines at a height, and upright ones at a node.
class ParallelPrismEdges {
 public:
  ParallelPrismEdges(const Sweeps& sweeps, const PlanarArrangement& arrangement,
                     const Slabs& slabs);

  [[nodiscard]] Vec3 place(const Vec3& p, int height) const;
  [[nodiscard]] Vec3 axis() const { return sweeps_.frame.rotate({0, 0, 1}); }
  [[nodiscard]] const kernel::BrepEdge& operator[](int edge) const { return brep_.edges[edge]; }

  /// The edge on a piece at a height, from node a to b.
  int level(int piece, int height);
  /// Adds the edges at a node in some slabs, where walls meet in more than a straight one that goes
  /// on; one may reach over several slabs.
  void add_upright(int node, int first, int last, std::vector<int>& edges);

  /// Vertices, edges, points, and these faces, which have used the edges. Lines are joined where
  /// nothing else ends between them.
  ///
  /// Post: this is of no more use.
  kernel::Brep finish(std::vector<kernel::BrepFace> faces);

 private:
  int vertex(int node, int height);
  int add_line(int a, int b);
  [[nodiscard]] kernel::BrepEdge line(int a, int b) const {
    return kernel::straight_edge(a, b, brep_.vertices[a].position, brep_.vertices[b].position);
  }
  int add_arc(const ArrangementEdge& piece, int height);
  int add_inner(const Vec3& p);
  [[nodiscard]] bool straight(int node, int p, int q, int slab) const;
  [[nodiscard]] bool stands(int node, int slab) const;
  void join_lines();

  const Sweeps& sweeps_;
  const PlanarArrangement& arrangement_;
  const Slabs& slabs_;
  kernel::Brep brep_;
  std::vector<Vec3> inner_;                ///< nodes that are no vertices
  std::vector<int> vertex_;                ///< by node and height
  std::vector<int> level_;                 ///< by piece and height
  std::vector<int> upright_;               ///< by node and its first slab
  std::vector<std::vector<int>> ends_at_;  ///< pieces by node, a circle twice
};

}  // namespace remeshd
