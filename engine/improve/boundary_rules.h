#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/cellular/boundary_model/support.h"
#include "engine/extract/common_face.h"
#include "engine/improve/local_mesh.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Which model faces a node with a support stands on, and which one a boundary facet represents.
class FacetFaces {
 public:
  /// Keeps references to both arguments.
  FacetFaces(const BoundaryModel& boundary, std::span<const Support> supports);

  /// Faces that a node stands on, ascending; none in the interior.
  [[nodiscard]] std::span<const int> faces_of(std::int32_t node) const {
    return faces_(supports_[node]);
  }
  /// The common face of the three nodes, which are at a, b and c, -1 if there is none. Where they
  /// share several (nodes on an edge curve), the one whose outward normal the facet's fits best; of
  /// those that it fits evenly, as on a strip of a wall that stands out of another by little, the
  /// one that lies there.
  [[nodiscard]] int face_of(const Triangle& facet, const Vec3& a, const Vec3& b,
                            const Vec3& c) const;
  /// Unit normal of the face out of the material.
  [[nodiscard]] Vec3 outward(int face, const Vec3& p) const;
  /// Signed distance of p from the face's surface, positive outside of the material.
  [[nodiscard]] double height(int face, const Vec3& p) const;
  [[nodiscard]] double deviation(int face, const Vec3& p) const {
    return std::fabs(height(face, p));
  }

 private:
  /// Of p, brought onto the face's surface, from the face.
  [[nodiscard]] double face_distance2(int face, const Vec3& p) const;

  const BoundaryModel& boundary_;
  std::span<const Support> supports_;
  FacesOf faces_;
};

/// What the clean-up may do to the boundary of a mesh: the surface stays a manifold, its facets
/// stay on their model faces and the chains along model edges stay.
class BoundaryRules {
 public:
  BoundaryRules(const BoundaryModel& boundary, std::span<const Support> supports,
                const LocalMesh& mesh, double chord_tolerance);

  [[nodiscard]] const FacetFaces& facet_faces() const { return faces_; }
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
