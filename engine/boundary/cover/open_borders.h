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
  int uses = 1;  ///< 2: the face is open on both sides of it
};

/// The borders of the open parts of a surface's faces. A link is the side between two neighbours in
/// the chain of nodes along a model edge; links on these borders may be halved. Every model vertex
/// gets a node.
class OpenBorders {
 public:
  /// Keeps references. `shortest`: length; no shorter link is halved.
  OpenBorders(SurfaceMesh& mesh, const std::vector<Triangle>& walls, const BoundaryModel& boundary,
              double shortest);

  /// The borders, by face. The border of what is open of a face has two kinds of sides: links of
  /// the face's model edges that are not a side of one of its facets that stay; and sides that are
  /// not links and belong to exactly one of its facets that stay.
  [[nodiscard]] std::map<std::int32_t, std::vector<BorderSide>> find();

  /// Whether a side is a link that `find` found last, and not halved since.
  [[nodiscard]] bool is_link(const Side& side) const { return links_.contains(side); }
  [[nodiscard]] double length(const Side& side) const;
  /// Whether a side is longer than `shortest`, and of no facet that stays and of no wall.
  [[nodiscard]] bool may_halve(const Side& side) const;
  /// Halves a link that `find` found last; false where it has been halved since.
  bool halve_link(const Side& side);

  /// Adds a node at the point of the support that is nearest to `near`.
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
  std::map<Side, int> links_;                                   ///< its model edge
};

}  // namespace remeshd
