#include <cmath>
#include <string>

#include "engine/base/angle.h"
#include "engine/model/profile.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

using Kind = Surface::Kind;

/// Local plane through a point with the given outward normal.
Surface plane(const Vec3& point, const Vec3& normal) {
  const Vec3 x = any_perpendicular(normal);
  return {Kind::Plane, Transform::frame(x, cross(normal, x), normal, point), 0, 0};
}
Surface cylinder(const Vec3& centre, double radius) {
  return {Kind::Cylinder, Transform::translation(centre), radius, 0};
}
Surface cone(double z, double radius, double slope) {
  return {Kind::Cone, Transform::translation({0, 0, z}), radius, slope};
}
Surface sphere(double z, double radius) {
  return {Kind::Sphere, Transform::translation({0, 0, z}), radius, 0};
}
Surface torus(double z, double major, double minor) {
  return {Kind::Torus, Transform::translation({0, 0, z}), major, minor};
}
SolidFace bottom() { return {"bottom", plane({0, 0, 0}, {0, 0, -1})}; }
SolidFace top(double height) { return {"top", plane({0, 0, height}, {0, 0, 1})}; }

/// The surface that a straight side sweeps about z; the side's x is the distance from z.
Surface turned_segment(const ProfileSide& side, bool counter_clockwise) {
  const double dx = side.to[0] - side.from[0], dz = side.to[1] - side.from[1];
  const double negligible = 1e-12 * std::hypot(dx, dz);
  // Outward is to the right of the sides of a profile that runs counter-clockwise.
  if (std::fabs(dz) <= negligible)
    return plane({0, 0, side.from[1]}, {0, 0, (dx > 0) == counter_clockwise ? -1.0 : 1.0});
  if (std::fabs(dx) <= negligible) return cylinder({0, 0, 0}, side.from[0]);
  return cone(side.from[1], side.from[0], dx / dz);
}

Surface turned_arc(const ProfileSide& side) {
  if (std::fabs(side.centre[0]) <= 1e-12 * side.radius) return sphere(side.centre[1], side.radius);
  return torus(side.centre[1], side.centre[0], side.radius);
}

struct LocalFaces {
  using Faces = std::vector<SolidFace>;

  Faces operator()(const Block& s) const {
    return {{"x_min", plane({-s.dx / 2, 0, 0}, {-1, 0, 0})},
            {"x_max", plane({s.dx / 2, 0, 0}, {1, 0, 0})},
            {"y_min", plane({0, -s.dy / 2, 0}, {0, -1, 0})},
            {"y_max", plane({0, s.dy / 2, 0}, {0, 1, 0})},
            bottom(),
            top(s.dz)};
  }
  Faces operator()(const Cylinder& s) const {
    return {{"wall", cylinder({0, 0, 0}, s.radius)}, bottom(), top(s.height)};
  }
  Faces operator()(const Cone& s) const {
    const double slope = (s.radius_top - s.radius_bottom) / s.height;
    Faces faces{{"wall", slope == 0 ? cylinder({0, 0, 0}, s.radius_bottom)
                                    : cone(0, s.radius_bottom, slope)}};
    if (s.radius_bottom > 0) faces.push_back(bottom());
    if (s.radius_top > 0) faces.push_back(top(s.height));
    return faces;
  }
  Faces operator()(const Sphere& s) const { return {{"surface", sphere(0, s.radius)}}; }
  Faces operator()(const Torus& s) const {
    return {{"surface", torus(0, s.major_radius, s.minor_radius)}};
  }
  Faces operator()(const Prism& s) const {
    const double turn = signed_area(s.profile) > 0 ? 1 : -1;
    Faces faces;
    for (std::size_t k = 0; k < s.profile.size(); ++k) {
      const ProfileSide& side = s.profile[k];
      const Vec3 out{side.to[1] - side.from[1], side.from[0] - side.to[0], 0};
      faces.push_back({side_name(k),
                       side.arc ? cylinder({side.centre[0], side.centre[1], 0}, side.radius)
                                : plane({side.from[0], side.from[1], 0}, normalised(turn * out))});
    }
    faces.push_back(bottom());
    faces.push_back(top(s.height));
    return faces;
  }
  Faces operator()(const Revolution& s) const {
    const bool counter_clockwise = signed_area(s.profile) > 0;
    Faces faces;
    for (std::size_t k = 0; k < s.profile.size(); ++k) {
      const ProfileSide& side = s.profile[k];
      if (!side.arc && side.from[0] == 0 && side.to[0] == 0) continue;
      faces.push_back(
          {side_name(k), side.arc ? turned_arc(side) : turned_segment(side, counter_clockwise)});
    }
    if (s.angle < kTurn) {
      faces.push_back({"start", plane({0, 0, 0}, {0, -1, 0})});
      faces.push_back({"end", plane({0, 0, 0}, {-std::sin(s.angle), std::cos(s.angle), 0})});
    }
    return faces;
  }
  Faces operator()(const Slot& s) const {
    const double r = s.width / 2, centre = (s.length - s.width) / 2;
    return {{"wall", plane({0, -r, 0}, {0, -1, 0})},
            {"wall", cylinder({centre, 0, 0}, r)},
            {"wall", plane({0, r, 0}, {0, 1, 0})},
            {"wall", cylinder({-centre, 0, 0}, r)},
            bottom(),
            top(s.height)};
  }
};

}  // namespace

std::vector<SolidFace> faces_of(const Feature& feature) {
  std::vector<SolidFace> faces = std::visit(LocalFaces{}, feature.shape);
  for (SolidFace& face : faces) face.surface.frame = feature.placement * face.surface.frame;
  return faces;
}

}  // namespace remeshd
