#include "engine/sizing/size_rules.h"

#include <cmath>

#include "engine/base/angle.h"

namespace remeshd {

namespace {

constexpr double kLeastShare = 0.1;  // of the base size, where no least size is given
/// So many more edges are asked for on circles: they come out unevenly long.
constexpr double kReserve = 1.2;

/// A circle as the torus round it that has no tube.
Surface circle(const Curve& curve) {
  const Vec3 x = any_perpendicular(curve.direction);
  return {Surface::Kind::Torus,
          Transform::frame(x, cross(curve.direction, x), curve.direction, curve.origin),
          curve.radius, 0};
}

}  // namespace

SizeField size_field(const BoundaryModel& boundary, const Sizing& sizing, double base) {
  if (sizing.even) return SizeField(base);
  const SizeLimits limits{base, std::fmin(base, sizing.min_size.value_or(kLeastShare * base)),
                          sizing.growth - 1};
  std::vector<SizeSource> sources;
  if (sizing.edges_per_circle > 0) {
    const double per_radius = kTurn / (kReserve * sizing.edges_per_circle);
    for (const BoundaryFace& face : boundary.faces) {
      const Surface& surface = face.surface;
      if (surface.kind == Surface::Kind::Plane) continue;
      const Box box = box_of(face.points);
      // Of a steep cone edges may not grow as fast as its circles do.
      const double size = surface.kind == Surface::Kind::Cone
                              ? std::fmin(per_radius, limits.slope / std::fabs(surface.r2))
                              : per_radius * radius_of_curvature(surface, face.points.front());
      sources.push_back({surface, box, size});
    }
    for (const BoundaryEdge& edge : boundary.edges)
      if (edge.curve.kind == Curve::Kind::Circle)
        sources.push_back(
            {circle(edge.curve), box_of(edge.points), per_radius * edge.curve.radius});
  }
  return SizeField(limits, std::move(sources), boundary.bounds);
}

}  // namespace remeshd
