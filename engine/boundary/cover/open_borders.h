#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "engine/boundary/cover/cover_faces.h"
#include "engine/boundary/edge_chains.h"

namespace remeshd {

using Side = std::pair<std::int32_t, std::int32_t>;  // lower node first

inline Side side_of(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// A side of the border of what is open of a face.
struct BorderSide {
  Side side;
  std::int32_t edge =
      -1;        ///< the model edge that it is a link of; -1: a side of a facet that stays
  int uses = 1;  ///< 2: open on both sides
};

/// What is open of the faces of a surface: its borders, and their links along model edges, which
/// may be halved. Every model vertex gets a node.
class OpenBorders {
 public:
  /// Keeps references. `shortest`: length; no shorter link is halved.
  OpenBorders(SurfaceMesh& mesh, const std::vector<Triangle>& walls, const BoundaryModel& boundary,
              double shortest);

  /// By face: the links of its edges that no facet has that stays, and sides of such facets that
  /// are no links.
  [[nodiscard]] std::map<std::int32_t, std::vector<BorderSide>> find();

  /// Of those found last.
  [[nodiscard]] bool is_link(const Side& side) const { return links_.contains(side); }
  [[nodiscard]] double length(const Side& side) const;
  /// Whether a side is of no facet that stays, nor of a wall, and long enough.
  [[nodiscard]] bool may_halve(const Side& side) const;
  /// Halves a link; false where that has been done since they were found.
  bool halve_link(const Side& side);

  /// A new node where `near` is nearest to on the support.
  std::int32_t add_node(const Support& support, const Vec3& near);

 private:
  void require_vertices();
  [[nodiscard]] int times_kept(std::int32_t face, const Side& side) const;

  SurfaceMesh& mesh_;
  const BoundaryModel& boundary_;
  double shortest_;
  std::vector<std::vector<NodeOnEdge>> chains_;
  std::vector<std::pair<std::int32_t, Side>> sides_that_stay_;  ///< by face, sorted
  std::vector<Side> rigid_;                                     ///< may not be halved, sorted
  std::map<Side, std::pair<int, int>> links_;                   ///< edge and place in its chain
};

}  // namespace remeshd
