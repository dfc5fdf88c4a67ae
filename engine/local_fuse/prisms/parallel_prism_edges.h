#pragma once

#include <vector>

#include "engine/kernel/brep.h"
#include "engine/local_fuse/arrangement/slabs.h"

namespace remeshd {

/// Makes the vertices and edges of features with a common sweep direction when faces ask for them:
/// level edges, along a piece of the arrangement at a height, and upright ones, along the sweep
/// direction at a node. Heights and slabs are numbered as in Slabs.
class ParallelPrismEdges {
 public:
  ParallelPrismEdges(const Sweeps& sweeps, const PlanarArrangement& arrangement,
                     const Slabs& slabs);

  /// The point above p of the arrangement's plane at a height, in the model's coordinates.
  [[nodiscard]] Vec3 place(const Vec3& p, int height) const;
  [[nodiscard]] Vec3 axis() const { return sweeps_.frame.rotate({0, 0, 1}); }
  [[nodiscard]] const kernel::BrepEdge& operator[](int edge) const { return brep_.edges[edge]; }

  /// The number of the edge on a piece at a height; it runs from the piece's node a to b.
  int level(int piece, int height);
  /// Appends the upright edges at a node in the slabs `first` to `last`. There is one wherever
  /// walls end at the node, unless these are just two that continue each other straight. An edge
  /// may reach over several slabs.
  void add_upright(int node, int first, int last, std::vector<int>& edges);

  /// The B-rep of the vertices and edges made so far and of these faces, which refer to the edges.
  /// Collinear lines are joined where nothing else ends between them.
  ///
  /// Post: this object must not be used again.
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
  std::vector<Vec3> inner_;                ///< points of polylines that are no vertices
  std::vector<int> vertex_;                ///< by node and height
  std::vector<int> level_;                 ///< by piece and height
  std::vector<int> upright_;               ///< by node and the edge's lowest slab
  std::vector<std::vector<int>> ends_at_;  ///< by node: pieces that end there, a circle twice
};

}  // namespace remeshd
