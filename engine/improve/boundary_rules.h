#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/boundary/facet_faces.h"
#include "engine/improve/local_mesh.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// What the clean-up may do to the boundary of a mesh: the surface stays a manifold, its facets
/// stay on their model faces and the chains along model edges stay.
class BoundaryRules {
 public:
  BoundaryRules(const BoundaryModel& boundary, std::span<const Support> supports,
                const LocalMesh& mesh, double chord_tolerance);

  [[nodiscard]] const Support& support(std::int32_t node) const { return supports_[node]; }
  [[nodiscard]] bool interior(std::int32_t node) const {
    return supports_[node].kind == Support::Kind::Interior;
  }

  /// Whether the boundary edge a-b of an open ring may go, so that the surface has the edge between
  /// the first and the last node of the ring in its place.
  [[nodiscard]] bool may_swap(std::int32_t a, std::int32_t b, const EdgeRing& ring) const;

  /// The boundary facets at a node, outward; a node of the interior has none.
  /// Post: false where the node may not move: a model vertex, a node of the interior that lies on
  /// the boundary all the same, or one with a facet that lies on no model face.
  bool facets_at(std::int32_t node, std::vector<Triangle>& out) const;

  /// Whether the facets at a node stay upright on their faces, and off them by at most the chord
  /// tolerance more than now, when the node goes to `position`.
  [[nodiscard]] bool may_move(std::int32_t node, const Vec3& position,
                              std::span<const Triangle> facets) const;

  /// Where a node that wants to be at p stands on its surface or curve.
  [[nodiscard]] Vec3 settle(std::int32_t node, const Vec3& p) const;

 private:
  [[nodiscard]] int face_of(const Triangle& facet) const;
  [[nodiscard]] bool upright(int face, const Vec3& a, const Vec3& b, const Vec3& c) const;
  [[nodiscard]] bool on_model_edge(std::int32_t a, std::int32_t b) const;

  const BoundaryModel& boundary_;
  std::span<const Support> supports_;
  const LocalMesh& mesh_;
  double chord_tolerance_;
  FacetFaces faces_;
  std::vector<std::pair<std::int32_t, std::int32_t>> segments_;  ///< of all chains, sorted
};

}  // namespace remeshd
