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
  /// Keeps references. `chord_tolerance`: by how much one step may increase the distance of a
  /// boundary facet, or of a swapped edge, from its curved face, x the longest side of that.
  BoundaryRules(const BoundaryModel& boundary, std::span<const Support> supports,
                const LocalMesh& mesh, double chord_tolerance);

  [[nodiscard]] bool interior(std::int32_t node) const {
    return supports_[node].kind == Support::Kind::Interior;
  }

  /// Whether the boundary edge a-b of an open ring may go, so that the surface has the edge between
  /// the first and the last node of the ring in its place. Facets that lie along their face do so
  /// afterwards.
  [[nodiscard]] bool may_swap(std::int32_t a, std::int32_t b, const EdgeRing& ring) const;

  /// The boundary facets at a node, outward; a node of the interior has none.
  /// Post: false where the node may not move: it is at a model vertex or locked, its support is the
  /// interior but it is on the boundary of the mesh, or one of its facets lies on no model face.
  bool facets_at(std::int32_t node, std::vector<Triangle>& out) const;

  /// Whether, if the node goes to `position`, its facets stay upright on their faces and their
  /// distances from them grow by at most the chord tolerance, and none that lies along its face
  /// leaves it (FacetFaces::lies_along). `facets`: from `facets_at`.
  [[nodiscard]] bool may_move(std::int32_t node, const Vec3& position,
                              std::span<const Triangle> facets) const;

  /// p projected on the surface or curve that the node stands on; p itself in the interior.
  [[nodiscard]] Vec3 settle(std::int32_t node, const Vec3& p) const;

 private:
  [[nodiscard]] int face_of(const Triangle& facet) const;
  [[nodiscard]] bool upright(int face, const Vec3& a, const Vec3& b, const Vec3& c) const;
  /// Whether a facet lies along its face where the one that it replaces does.
  [[nodiscard]] bool stays_along(int face, const std::array<Vec3, 3>& now,
                                 const std::array<Vec3, 3>& then) const;
  [[nodiscard]] bool on_model_edge(std::int32_t a, std::int32_t b) const;

  const BoundaryModel& boundary_;
  std::span<const Support> supports_;
  const LocalMesh& mesh_;
  double chord_tolerance_;
  FacetFaces faces_;
  std::vector<std::pair<std::int32_t, std::int32_t>> segments_;  ///< along model edges, sorted
};

}  // namespace remeshd
