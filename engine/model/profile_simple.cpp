#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/error.h"
#include "engine/model/profile.h"

namespace remeshd {
namespace {

Point2 operator-(const Point2& a, const Point2& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point2 operator+(const Point2& a, const Point2& b) { return {a[0] + b[0], a[1] + b[1]}; }
Point2 operator*(double s, const Point2& a) { return {s * a[0], s * a[1]}; }
double dot(const Point2& a, const Point2& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }
double length(const Point2& a) { return std::hypot(a[0], a[1]); }

/// Whether a point of the arc's circle lies on the arc: on the side of the chord it bulges to.
bool on_arc(const ProfileSide& arc, const Point2& p) {
  const double left = cross(arc.to - arc.from, p - arc.from);
  return arc.counter_clockwise ? left <= 0 : left >= 0;
}

double distance_to(const ProfileSide& side, const Point2& p) {
  const double to_ends = std::min(length(p - side.from), length(p - side.to));
  if (!side.arc) {
    const Point2 d = side.to - side.from;
    const double t = dot(p - side.from, d) / dot(d, d);
    return t > 0 && t < 1 ? std::fabs(cross(d, p - side.from)) / length(d) : to_ends;
  }
  const Point2 out = p - side.centre;
  const double rho = length(out);
  if (rho == 0) return side.radius;
  const Point2 foot = side.centre + (side.radius / rho) * out;
  return on_arc(side, foot) ? std::fabs(rho - side.radius) : to_ends;
}

/// Points where the curves that carry two sides meet or come nearest; with the ends of the sides
/// these are all places where the sides themselves can touch.
void meet(const ProfileSide& a, const ProfileSide& b, std::vector<Point2>& out) {
  if (!a.arc && !b.arc) {
    const Point2 da = a.to - a.from, db = b.to - b.from;
    const double c = cross(da, db);
    if (c != 0) out.push_back(a.from + (cross(b.from - a.from, db) / c) * da);
    return;
  }
  if (a.arc != b.arc) {
    const ProfileSide& line = a.arc ? b : a;
    const ProfileSide& arc = a.arc ? a : b;
    const Point2 d = (1 / length(line.to - line.from)) * (line.to - line.from);
    const Point2 foot = line.from + dot(arc.centre - line.from, d) * d;
    out.push_back(foot);
    const double h = length(foot - arc.centre);
    if (h >= arc.radius) return;
    const double half = std::sqrt((arc.radius - h) * (arc.radius + h));
    out.push_back(foot + half * d);
    out.push_back(foot + (-half) * d);
    return;
  }
  const double gap = length(b.centre - a.centre);
  if (gap == 0) return;
  const Point2 axis = (1 / gap) * (b.centre - a.centre);
  out.push_back(a.centre + a.radius * axis);
  out.push_back(a.centre + (-a.radius) * axis);
  const double along = (gap * gap + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * gap);
  const double half2 = (a.radius - along) * (a.radius + along);
  if (half2 <= 0) return;
  const Point2 across{-axis[1], axis[0]};
  const Point2 middle = a.centre + along * axis;
  out.push_back(middle + std::sqrt(half2) * across);
  out.push_back(middle + (-std::sqrt(half2)) * across);
}

/// Whether the sides touch within `tolerance` other than near the `shared` points.
bool touch(const ProfileSide& a, const ProfileSide& b, const std::vector<Point2>& shared,
           double tolerance) {
  std::vector<Point2> candidates{a.from, a.to, b.from, b.to};
  meet(a, b, candidates);
  for (const Point2& p : candidates) {
    // Where two curves meet at a flat angle rounding moves the point along them, not off them.
    const bool known = std::any_of(shared.begin(), shared.end(), [&](const Point2& s) {
      return length(p - s) <= 1e3 * tolerance;
    });
    if (!known && distance_to(a, p) <= tolerance && distance_to(b, p) <= tolerance) return true;
  }
  return false;
}

/// Unit direction in which a side leaves one of its ends.
Point2 direction_from(const ProfileSide& side, bool from_start) {
  const Point2 end = from_start ? side.from : side.to;
  Point2 d = from_start ? side.to - side.from : side.from - side.to;
  if (side.arc) {
    const Point2 radial = end - side.centre;
    d = {-radial[1], radial[0]};
    if (side.counter_clockwise != from_start) d = -1.0 * d;
  }
  return (1 / length(d)) * d;
}

bool apart(const Box2& a, const Box2& b, double margin) {
  return a.lo[0] > b.hi[0] + margin || b.lo[0] > a.hi[0] + margin || a.lo[1] > b.hi[1] + margin ||
         b.lo[1] > a.hi[1] + margin;
}

}  // namespace

void check_simple(const std::vector<ProfileSide>& sides, const std::string& feature) {
  const std::size_t n = sides.size();
  const double tolerance = profile_tolerance(sides);
  std::vector<Box2> boxes;
  for (const ProfileSide& side : sides) boxes.push_back(side_bounds(side));

  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const Point2 back = direction_from(sides[k], false);
    const Point2 on = direction_from(sides[next], true);
    if (dot(back, on) > 0 && std::fabs(cross(back, on)) < 1e-6)
      throw error::self_intersecting_profile(
          feature, entry_name(next),
          side_name(k) + " and " + side_name(next) + " leave their common end in one direction");
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (apart(boxes[i], boxes[j], tolerance)) continue;
      std::vector<Point2> shared;
      if (j == i + 1) shared.push_back(sides[i].to);
      if (i == 0 && j == n - 1) shared.push_back(sides[0].from);
      if (touch(sides[i], sides[j], shared, tolerance))
        throw error::self_intersecting_profile(feature, entry_name(j),
                                               side_name(i) + " and " + side_name(j) + " meet");
    }
  }
}

}  // namespace remeshd
