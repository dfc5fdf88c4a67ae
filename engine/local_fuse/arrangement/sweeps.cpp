#include "engine/local_fuse/arrangement/sweeps.h"

#include <algorithm>
#include <cmath>

#include "engine/base/angle.h"
#include "engine/base/tolerance.h"

namespace remeshd {
namespace {

Vec3 column(const Transform& t, int k) { return {t.m[k], t.m[4 + k], t.m[8 + k]}; }

bool parallel(const Vec3& a, const Vec3& b) { return norm(cross(a, b)) <= tolerance::kRounding; }

/// The local axes (0 is x) along which a shape is swept: all three of a block, none of a sphere.
std::vector<int> axes_of(const Shape& shape) {
  if (std::holds_alternative<Block>(shape)) return {2, 0, 1};
  if (const auto* cone = std::get_if<Cone>(&shape))
    return cone->radius_bottom == cone->radius_top ? std::vector{2} : std::vector<int>{};
  if (std::holds_alternative<Cylinder>(shape) || std::holds_alternative<Prism>(shape) ||
      std::holds_alternative<Slot>(shape))
    return {2};
  return {};
}

/// Which of these axes of a feature is parallel to a direction; -1 where none is.
int axis_along(const Feature& feature, const Vec3& direction) {
  for (const int k : axes_of(feature.shape))
    if (parallel(column(feature.placement, k), direction)) return k;
  return -1;
}

SweepSide segment(const Vec3& from, const Vec3& to, const SolidFace& face) {
  return {.from = from, .to = to, .face = &face};
}

/// A feature in its own frame, swept along one of its axes.
struct LocalSweep {
  const std::vector<SolidFace>& faces;
  int axis;

  Sweep operator()(const Block& b) const {
    const std::array<double, 3> low{-b.dx / 2, -b.dy / 2, 0}, high{b.dx / 2, b.dy / 2, b.dz};
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto at = [&](bool high_u, bool high_v) {
      std::array<double, 3> p{};
      p[u] = high_u ? high[u] : low[u];
      p[v] = high_v ? high[v] : low[v];
      return Vec3{p[0], p[1], p[2]};
    };
    Sweep out{.low = low[axis], .high = high[axis]};
    out.bottom = &faces[2 * axis];
    out.top = &faces[2 * axis + 1];
    out.sides = {segment(at(false, false), at(true, false), faces[2 * v]),
                 segment(at(true, false), at(true, true), faces[2 * u + 1]),
                 segment(at(true, true), at(false, true), faces[2 * v + 1]),
                 segment(at(false, true), at(false, false), faces[2 * u])};
    return out;
  }
  Sweep operator()(const Cylinder& c) const { return round(c.radius, c.height); }
  Sweep operator()(const Cone& c) const { return round(c.radius_bottom, c.height); }
  Sweep operator()(const Prism& p) const {
    Sweep out = along_z(p.height);
    for (std::size_t k = 0; k < p.profile.size(); ++k) {
      const ProfileSide& side = p.profile[k];
      out.sides.push_back({{side.from[0], side.from[1], 0},
                           {side.to[0], side.to[1], 0},
                           side.arc,
                           {side.centre[0], side.centre[1], 0},
                           side.radius,
                           side.counter_clockwise,
                           &faces[k]});
    }
    return out;
  }
  Sweep operator()(const Slot& s) const {
    const double r = s.width / 2, x = s.length / 2 - r;
    if (x <= 0) return round(r, s.height);
    Sweep out = along_z(s.height);
    const Vec3 right{x, 0, 0}, left{-x, 0, 0}, up{0, r, 0};
    out.sides = {segment(left - up, right - up, faces[0]),
                 {right - up, right + up, true, right, r, true, &faces[1]},
                 segment(right + up, left + up, faces[2]),
                 {left + up, left - up, true, left, r, true, &faces[3]}};
    return out;
  }
  template <typename Other>
  Sweep operator()(const Other& /*shape*/) const {
    return {};
  }

 private:
  [[nodiscard]] Sweep along_z(double height) const {
    Sweep out{.low = 0, .high = height};
    out.bottom = &faces[faces.size() - 2];
    out.top = &faces.back();
    return out;
  }
  [[nodiscard]] Sweep round(double radius, double height) const {
    Sweep out = along_z(height);
    const Vec3 seam{radius, 0, 0};
    out.sides = {{seam, seam, true, {}, radius, true, &faces.front()}};
    return out;
  }
};

/// Twice the signed area within an outline: positive where it runs counter-clockwise.
double turning(const std::vector<SweepSide>& sides) {
  double area = 0;
  for (const SweepSide& side : sides) {
    area += cross(side.from, side.to).z;
    if (!side.round) continue;
    // The area between an arc and its chord, or all of a circle.
    const Vec3 a = side.from - side.centre, b = side.to - side.centre;
    double angle = std::atan2(cross(a, b).z, dot(a, b));
    if (side.left_turn && angle <= 0) angle += kTurn;
    if (!side.left_turn && angle >= 0) angle -= kTurn;
    area += side.radius * side.radius * (angle - std::sin(angle));
  }
  return area;
}

/// A sweep along a local axis, put into a frame whose z axis is parallel to that or opposite.
Sweep moved(Sweep sweep, const Transform& to, int axis) {
  const auto flat = [&](const Vec3& p) {
    const Vec3 q = to.apply(p);
    return Vec3{q.x, q.y, 0};
  };
  const Vec3 along = column(Transform(), axis);
  const bool same_way = to.rotate(along).z > 0;
  sweep.low = to.apply(sweep.low * along).z;
  sweep.high = to.apply(sweep.high * along).z;
  if (!same_way) {
    std::swap(sweep.low, sweep.high);
    std::swap(sweep.bottom, sweep.top);
  }
  for (SweepSide& side : sweep.sides) {
    const bool closed = side.closed();
    side.from = flat(side.from);
    side.to = closed ? side.from : flat(side.to);
    side.centre = flat(side.centre);
    side.left_turn = side.left_turn == same_way;  // the outline turns over with the axis
  }
  if (turning(sweep.sides) < 0) {
    std::ranges::reverse(sweep.sides);
    for (SweepSide& side : sweep.sides) {
      std::swap(side.from, side.to);
      side.left_turn = !side.left_turn;
    }
  }
  return sweep;
}

/// The sweep directions that the features may have in common: those of one with the fewest.
///
/// Pre: there is a feature.
std::vector<Vec3> candidates(const FeatureModel& model, std::span<const int> features) {
  const int fewest = *std::ranges::min_element(
      features, {}, [&](int f) { return axes_of(model.features[f].shape).size(); });
  std::vector<Vec3> out;
  for (const int k : axes_of(model.features[fewest].shape))
    out.push_back(column(model.features[fewest].placement, k));
  return out;
}

}  // namespace

Tried<Sweeps> find_sweeps(const FeatureModel& model, const Membership& membership,
                          std::span<const int> features) {
  if (features.empty()) return GaveUp{"sweeps", "there are no features"};
  const std::vector<Vec3> directions = candidates(model, features);
  if (directions.empty()) return GaveUp{"sweeps", "a feature is neither a prism nor a cylinder"};
  for (const Vec3& z : directions) {
    if (std::ranges::any_of(features, [&](int f) { return axis_along(model.features[f], z) < 0; }))
      continue;
    const Vec3 x = any_perpendicular(z);
    Sweeps out{Transform::frame(x, cross(z, x), z, {}), {}};
    const Transform into = rigid_inverse(out.frame);
    for (const int f : features) {
      const Feature& feature = model.features[f];
      const int axis = axis_along(feature, z);
      out.sweeps.push_back(
          moved(std::visit(LocalSweep{membership.solids()[f].faces(), axis}, feature.shape),
                into * feature.placement, axis));
      out.sweeps.back().feature = f;
    }
    return out;
  }
  return GaveUp{"sweeps", "no direction is along an axis of every feature"};
}

}  // namespace remeshd
