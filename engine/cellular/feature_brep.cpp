#include "engine/cellular/feature_brep.h"

#include "engine/kernel/primitives.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::ProfileCurve;

std::vector<ProfileCurve> profile_curves(const std::vector<ProfileSide>& sides) {
  std::vector<ProfileCurve> curves;
  for (const ProfileSide& side : sides)
    curves.push_back({side.from, side.to, side.arc, side.centre, side.radius,
                      side.counter_clockwise, "side" + std::to_string(curves.size() + 1)});
  return curves;
}

ProfileCurve segment(std::array<double, 2> from, std::array<double, 2> to, std::string label) {
  return {.from = from, .to = to, .label = std::move(label)};
}

struct Builder {
  double scale;

  Brep operator()(const Block& b) const {
    const double x = b.dx / 2, y = b.dy / 2;
    return kernel::make_prism(
        std::array{segment({-x, -y}, {x, -y}, "y_min"), segment({x, -y}, {x, y}, "x_max"),
                   segment({x, y}, {-x, y}, "y_max"), segment({-x, y}, {-x, -y}, "x_min")},
        b.dz, scale);
  }
  Brep operator()(const Cylinder& c) const {
    return kernel::make_cone(c.radius, c.radius, c.height, scale);
  }
  Brep operator()(const Cone& c) const {
    return kernel::make_cone(c.radius_bottom, c.radius_top, c.height, scale);
  }
  Brep operator()(const Sphere& s) const { return kernel::make_sphere(s.radius, scale); }
  Brep operator()(const Torus& t) const {
    return kernel::make_torus(t.major_radius, t.minor_radius, scale);
  }
  Brep operator()(const Prism& p) const {
    return kernel::make_prism(profile_curves(p.profile), p.height, scale);
  }
  Brep operator()(const Revolution& r) const {
    return kernel::make_revolution(profile_curves(r.profile), r.angle, scale);
  }
  Brep operator()(const Slot& s) const {
    const double r = s.width / 2, x = s.length / 2 - r;
    // As long as wide: round.
    if (2 * x <= kernel::shortest_edge(scale)) return kernel::make_cone(r, r, s.height, scale);
    const auto half_circle = [&](double centre, std::array<double, 2> from,
                                 std::array<double, 2> to) {
      return ProfileCurve{from, to, true, {centre, 0}, r, true, "wall"};
    };
    return kernel::make_prism(
        std::array{segment({-x, -r}, {x, -r}, "wall"), half_circle(x, {x, -r}, {x, r}),
                   segment({x, r}, {-x, r}, "wall"), half_circle(-x, {-x, r}, {-x, -r})},
        s.height, scale);
  }
};

}  // namespace

Brep feature_brep(const Feature& feature, double scale) {
  return std::visit(Builder{scale}, feature.shape);
}

}  // namespace remeshd
