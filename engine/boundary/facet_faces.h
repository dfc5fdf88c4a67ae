#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/cellular/boundary_model/support.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// How far a boundary facet may be from its face at its centroid and at the middles of its edges,
/// as a share of its longest edge. The chord of a third of a circle has 0.29, as is fair where a
/// coarse mesh meets a small hole; that of a half, across the hole, has 0.5.
inline constexpr double kChordShare = 0.45;

/// The model faces that a node with a given support lies on, looked up fast.
class FacesOf {
 public:
  explicit FacesOf(const BoundaryModel& boundary);
  /// The same, but faces that only rims of groups separate count as one, that of the lowest index.
  static FacesOf across_rims(const BoundaryModel& boundary);

  /// Ascending face indices: the face itself, those of the edge, those round the vertex; none in
  /// the interior.
  [[nodiscard]] std::span<const int> operator()(const Support& support) const;

  /// Of the faces that all these supports share the first that is planar, else the first; -1 if
  /// they share none.
  [[nodiscard]] int common(std::span<const Support> supports) const;

 private:
  std::vector<int> face_;  ///< identity, so that a face gives a span too
  std::vector<std::vector<int>> edge_, vertex_;
  std::vector<std::uint8_t> plane_;  ///< by face: whether it is planar
};

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
  /// share several (nodes on an edge curve), the one whose outward normal is closest to the
  /// facet's; of those that are about equally close, as on a narrow step between two walls, the one
  /// whose triangulation is nearest to the facet's centroid.
  [[nodiscard]] int face_of(const Triangle& facet, const Vec3& a, const Vec3& b,
                            const Vec3& c) const;
  /// Whether the axis of the face's surface, or the circle in the middle of a torus's tube, passes
  /// through a facet with these corners: it closes off a hole, or cuts through a pin, instead of
  /// lying along its wall. False for planes and spheres.
  [[nodiscard]] bool lies_across(int face, const std::array<Vec3, 3>& corners) const;
  /// Whether a facet with these corners is nowhere further from the face than a chord may be, and
  /// does not lie across it.
  [[nodiscard]] bool lies_along(int face, const std::array<Vec3, 3>& corners) const;
  /// The same; `off`: how far it is at most, at its centroid and at the middles of its edges.
  [[nodiscard]] bool lies_along(int face, const std::array<Vec3, 3>& corners, double off) const;
  /// Unit normal of the face out of the material.
  [[nodiscard]] Vec3 outward(int face, const Vec3& p) const;
  /// Signed distance of p from the face's surface, positive outside of the material.
  [[nodiscard]] double height(int face, const Vec3& p) const;
  [[nodiscard]] double deviation(int face, const Vec3& p) const {
    return std::fabs(height(face, p));
  }

 private:
  /// Squared distance of p, projected onto the face's surface, from the face's triangulation.
  [[nodiscard]] double face_distance2(int face, const Vec3& p) const;

  const BoundaryModel& boundary_;
  std::span<const Support> supports_;
  FacesOf faces_;
};

}  // namespace remeshd
