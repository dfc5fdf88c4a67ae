#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/run.h"
#include "engine/boundary/surface_mesh.h"

namespace remeshd {

/// Changes a surface mesh step by step: sides are split and collapsed towards the length that their
/// ends ask for, sides within a face flipped, nodes evened out. What stays: the surface is closed
/// and manifold, nodes stand on their supports, model vertices keep their node and model edges
/// their chain, and no step leaves a facet off its face: each new one is within 50 degrees of it.
///
/// Source: Botsch & Kobbelt 2004, "A remeshing approach to multiresolution modeling".
class SurfaceRemesher {
 public:
  /// The longest sides that a node with this support may have at a place, > 0.
  using LongestAt = std::function<double(const Support&, const Vec3&)>;

  /// Keeps references to `boundary` and `run`.
  SurfaceRemesher(SurfaceMesh mesh, const BoundaryModel& boundary, LongestAt longest,
                  const Run& run);

  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_; }

  /// Asks for sides of this length at most at a node; `grade` has to follow.
  void shorten(std::int32_t node, double length) {
    lengths_[node] = std::min(lengths_[node], length);
  }
  /// Lowers the lengths asked for until none exceeds that of a neighbouring node by more than half
  /// of their distance (gradation; by Dijkstra's algorithm).
  void grade();

  /// Splits sides that are longer than `limit` x the length asked for, by default 4/3, the longest
  /// first.
  void split_long(double limit);
  void split_long();
  /// Collapses sides that are shorter than 4/5 of the length asked for, the shortest first.
  void collapse_short();
  /// Flips sides within faces while that improves the worse of their two facets.
  void flip();
  /// Moves every node to the mean of its neighbours, projected onto its support (Laplacian
  /// smoothing), where the worst of its facets does not get worse or stays of fair shape.
  void even_out();
  /// Takes out the nodes and facets that are gone; the others are numbered anew, in their order.
  void compact();

 private:
  /// A side with the two facets at it: `left` has it from a to b, `right` from b to a.
  struct Side {
    std::int32_t a, b;
    std::int32_t left, right;
    std::int32_t apex_left, apex_right;
    std::int32_t edge;  ///< model edge, -1 within a face
  };
  struct Job {
    double key;
    std::int32_t a, b;
    /// By key; of equal keys the job with lower nodes is the greater, so that it comes first.
    friend bool operator<(const Job& x, const Job& y) {
      return x.key != y.key ? x.key < y.key : std::pair{x.a, x.b} > std::pair{y.a, y.b};
    }
  };

  [[nodiscard]] std::optional<Side> side(std::int32_t a, std::int32_t b) const;
  /// Length of a side over the length asked for, the mean of that at its ends.
  [[nodiscard]] double ratio(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] double shape(int face, const Vec3& a, const Vec3& b, const Vec3& c) const;
  /// Shape of a facet with node n at p.
  [[nodiscard]] double shape_with(const FaceFacet& facet, std::int32_t n, const Vec3& p) const;
  [[nodiscard]] std::int32_t edge_between(std::int32_t facet, std::int32_t a, std::int32_t b) const;
  [[nodiscard]] bool joined(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] std::vector<std::int32_t> neighbours(std::int32_t n) const;
  /// Sides whose ratio is above or below a limit.
  [[nodiscard]] std::vector<Job> sides_beyond(double limit, bool above) const;
  [[nodiscard]] bool may_collapse(const Side& s, std::int32_t from, std::int32_t to) const;
  [[nodiscard]] std::optional<Vec3> evened_place(std::int32_t n) const;
  bool split(const Side& s);
  void collapse(const Side& s, std::int32_t from, std::int32_t to);
  bool try_flip(const Side& s);
  std::int32_t add(const FaceFacet& facet);
  void remove(std::int32_t facet);

  SurfaceMesh mesh_;  ///< facets with face -1 are gone
  const BoundaryModel& boundary_;
  LongestAt longest_;
  const Run& run_;
  std::vector<double> lengths_;                ///< of sides asked for, by node
  std::vector<std::vector<std::int32_t>> at_;  ///< by node: its facets
};

}  // namespace remeshd
