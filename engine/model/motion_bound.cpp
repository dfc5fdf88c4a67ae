#include <algorithm>
#include <cmath>

#include "engine/base/tolerance.h"
#include "engine/model/feature_model.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

double gap(double a, double b) { return std::fabs(a - b); }
double gap(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double gap(const std::vector<ProfileSide>& a, const std::vector<ProfileSide>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].arc != b[k].arc || a[k].counter_clockwise != b[k].counter_clockwise) return HUGE_VAL;
    largest = std::max({largest, gap(a[k].from, b[k].from), gap(a[k].to, b[k].to),
                        gap(a[k].centre, b[k].centre) + gap(a[k].radius, b[k].radius)});
  }
  return largest;
}

/// Bound of the distance that a surface moves in the feature's own frame.
struct ShapeGap {
  double extent;  ///< how far the shape reaches from its z axis

  double operator()(const Block& a, const Block& b) const {
    return std::max({gap(a.dx, b.dx), gap(a.dy, b.dy), gap(a.dz, b.dz)});
  }
  double operator()(const Cylinder& a, const Cylinder& b) const {
    return std::max(gap(a.radius, b.radius), gap(a.height, b.height));
  }
  double operator()(const Cone& a, const Cone& b) const {
    // A face appears or goes where a radius leaves zero.
    if ((a.radius_bottom == 0) != (b.radius_bottom == 0) ||
        (a.radius_top == 0) != (b.radius_top == 0))
      return HUGE_VAL;
    return std::max(gap(a.radius_bottom, b.radius_bottom), gap(a.radius_top, b.radius_top)) +
           gap(a.height, b.height);
  }
  double operator()(const Sphere& a, const Sphere& b) const { return gap(a.radius, b.radius); }
  double operator()(const Torus& a, const Torus& b) const {
    return gap(a.major_radius, b.major_radius) + gap(a.minor_radius, b.minor_radius);
  }
  double operator()(const Prism& a, const Prism& b) const {
    return std::max(gap(a.profile, b.profile), gap(a.height, b.height));
  }
  double operator()(const Revolution& a, const Revolution& b) const {
    return std::max(gap(a.profile, b.profile), extent * gap(a.angle, b.angle));
  }
  double operator()(const Slot& a, const Slot& b) const {
    return gap(a.length, b.length) + gap(a.width, b.width) + gap(a.height, b.height);
  }
  template <class A, class B>
  double operator()(const A&, const B&) const {
    return HUGE_VAL;
  }
};

}  // namespace

double motion_bound(const Feature& a, const Feature& b) {
  if (a.nature != b.nature) return HUGE_VAL;
  Box local = local_bounds(a.shape);
  local.add(local_bounds(b.shape));
  double placed = 0;
  double extent = 0;
  for (const Vec3& c : corners_of(local)) {
    placed = std::max(placed, distance(a.placement.apply(c), b.placement.apply(c)));
    extent = std::max(extent, std::hypot(c.x, c.y));
  }
  return placed + std::visit(ShapeGap{extent}, a.shape, b.shape);
}

double motion_bound(const FeatureModel& a, const FeatureModel& b) {
  if (a.features.size() != b.features.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t k = 0; k < a.features.size(); ++k) {
    const Feature& f = a.features[k];
    const Feature& g = b.features[k];
    if (f.id != g.id) return HUGE_VAL;
    largest = std::max(largest, motion_bound(f, g));
  }
  return largest;
}

Box additive_bounds(const FeatureModel& model) {
  Box box;
  for (const Feature& feature : model.features)
    if (feature.nature == Nature::Additive) box.add(world_bounds(feature));
  return box;
}

bool same_geometry(const FeatureModel& a, const FeatureModel& b) {
  return motion_bound(a, b) <= tolerance::kRounding * additive_bounds(a).diagonal();
}

}  // namespace remeshd
