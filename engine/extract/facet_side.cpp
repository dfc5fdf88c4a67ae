#include "engine/extract/facet_side.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/cellular/boundary_model/face_distance.h"

namespace remeshd {

namespace {

struct FacetLimits {
  double turn = 0.85;     ///< cosine between the normals of a facet and of its face, at least
  double off_face = 0.1;  ///< x longest edge: how far its projected middle is off the face, at most
  double rounding = 1e-9;  ///< x an edge: a point nearer to a surface lies on it
};
constexpr FacetLimits kFacetLimits;

/// A facet with its nodes on one curved face.
struct Chord {
  Vec3 a, b, c;
  const BoundaryFace& face;

  [[nodiscard]] Vec3 middle() const { return (a + b + c) / 3.0; }
  [[nodiscard]] Vec3 on_surface() const { return project(face.surface, middle()); }
  [[nodiscard]] double height() const { return distance(middle(), on_surface()); }
  /// Unit normal, out of the material.
  [[nodiscard]] Vec3 normal() const {
    const Vec3 n = normalised(cross(b - a, c - a));
    return dot(n, outward_normal(face, on_surface())) < 0 ? -n : n;
  }
  /// How far a point lies off the surface, negative on the side of the material; 0 within rounding.
  [[nodiscard]] double beyond_face(const Vec3& p) const {
    const Vec3 on = project(face.surface, p);
    const double off = dot(p - on, outward_normal(face, on));
    return std::fabs(off) < kFacetLimits.rounding * norm(b - a) ? 0 : off;
  }
  /// Whether it may be a facet of the boundary: its normal is near the face's, so that it does not
  /// cut across a concave face, and its middle is on the face, not in a hole of it.
  [[nodiscard]] bool follows_face() const {
    const Vec3 n = normal();
    const bool turns = std::ranges::all_of(std::array{a, b, c, on_surface()}, [&](const Vec3& p) {
      return dot(n, outward_normal(face, p)) >= kFacetLimits.turn;
    });
    const double longest2 = std::max({norm2(b - a), norm2(c - b), norm2(a - c)});
    return turns && face_distance2(face, on_surface()) <=
                        kFacetLimits.off_face * kFacetLimits.off_face * longest2;
  }
};

}  // namespace

BoundarySide side_by_facets(const NodeSet& nodes, const BoundaryModel& boundary,
                            const FacesOf& faces, const Tet& tet) {
  BoundarySide side = BoundarySide::Unknown;
  for (int i = 0; i < 4; ++i) {
    std::array<std::int32_t, 3> corners;
    std::ranges::transform(kTetFacets[i], corners.begin(), [&](int k) { return tet[k]; });
    std::array<Support, 3> supports;
    std::ranges::transform(corners, supports.begin(),
                           [&](std::int32_t n) { return nodes.supports[n]; });
    const int f = faces.common(supports);
    if (f < 0 || boundary.faces[f].surface.kind == Surface::Kind::Plane) continue;
    const Chord chord{nodes.positions[corners[0]], nodes.positions[corners[1]],
                      nodes.positions[corners[2]], boundary.faces[f]};
    if (norm2(cross(chord.b - chord.a, chord.c - chord.a)) == 0) continue;
    const double height = dot(nodes.positions[tet[i]] - chord.middle(), chord.normal());
    const double of_centroid = 0.25 * std::fabs(height);
    if (of_centroid > chord.height() || !chord.follows_face()) continue;
    if (height * chord.beyond_face(nodes.positions[tet[i]]) < 0) continue;
    const BoundarySide here = height < 0 ? BoundarySide::Inside : BoundarySide::Outside;
    if (side != BoundarySide::Unknown && side != here) return BoundarySide::Unknown;
    side = here;
  }
  return side;
}

}  // namespace remeshd
