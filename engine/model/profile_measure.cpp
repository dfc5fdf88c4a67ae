#include <algorithm>
#include <cmath>

#include "engine/base/angle.h"
#include "engine/model/profile.h"

namespace remeshd {
namespace {

/// The piece between an arc and its chord: area with the sign of the turn, and centroid.
struct Segment {
  double area = 0;
  double centroid_x = 0;
};

/// t - sin t without the cancellation of small angles.
double minus_sine(double t) {
  if (std::fabs(t) > 0.1) return t - std::sin(t);
  const double s = t * t;
  return t * s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72)));
}

Segment segment_of(const ProfileSide& arc) {
  const double t = sweep(arc);
  const double excess = minus_sine(std::fabs(t));
  const double half_sine = std::sin(std::fabs(t) / 2);
  const double reach = 4 * arc.radius * half_sine * half_sine * half_sine / (3 * excess);
  const double middle =
      std::atan2(arc.from[1] - arc.centre[1], arc.from[0] - arc.centre[0]) + t / 2;
  return {std::copysign(0.5 * arc.radius * arc.radius * excess, t),
          arc.centre[0] + reach * std::cos(middle)};
}

}  // namespace

void Box2::add(const Point2& p) {
  for (int k = 0; k < 2; ++k) {
    lo[k] = std::min(lo[k], p[k]);
    hi[k] = std::max(hi[k], p[k]);
  }
}

double Box2::diagonal() const { return std::hypot(hi[0] - lo[0], hi[1] - lo[1]); }

double sweep(const ProfileSide& arc) {
  const double ux = arc.from[0] - arc.centre[0], uy = arc.from[1] - arc.centre[1];
  const double vx = arc.to[0] - arc.centre[0], vy = arc.to[1] - arc.centre[1];
  const double turn = std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
  if (arc.counter_clockwise) return turn < 0 ? turn + kTurn : turn;
  return turn > 0 ? turn - kTurn : turn;
}

Box2 side_bounds(const ProfileSide& side) {
  Box2 box;
  box.add(side.from);
  box.add(side.to);
  if (!side.arc) return box;
  const double dx = side.to[0] - side.from[0], dy = side.to[1] - side.from[1];
  for (const Point2& way : {Point2{1, 0}, Point2{0, 1}, Point2{-1, 0}, Point2{0, -1}}) {
    const Point2 p{side.centre[0] + side.radius * way[0], side.centre[1] + side.radius * way[1]};
    const double left = dx * (p[1] - side.from[1]) - dy * (p[0] - side.from[0]);
    // A counter-clockwise arc bulges to the right of its chord.
    if (side.counter_clockwise ? left < 0 : left > 0) box.add(p);
  }
  return box;
}

Box2 profile_bounds(const std::vector<ProfileSide>& sides) {
  Box2 box;
  for (const ProfileSide& side : sides) {
    const Box2 part = side_bounds(side);
    box.add(part.lo);
    box.add(part.hi);
  }
  return box;
}

double profile_tolerance(const std::vector<ProfileSide>& sides) {
  return 1e-9 * profile_bounds(sides).diagonal();
}

double signed_area(const std::vector<ProfileSide>& sides) {
  // From a corner of the profile, so that a far origin costs no digits.
  const Point2 o = sides.front().from;
  double area = 0;
  for (const ProfileSide& side : sides) {
    area += 0.5 * ((side.from[0] - o[0]) * (side.to[1] - o[1]) -
                   (side.to[0] - o[0]) * (side.from[1] - o[1]));
    if (side.arc) area += segment_of(side).area;
  }
  return area;
}

double moment_about_axis(const std::vector<ProfileSide>& sides) {
  const Point2 o = sides.front().from;
  double moment = 0;
  for (const ProfileSide& side : sides) {
    const double triangle = 0.5 * ((side.from[0] - o[0]) * (side.to[1] - o[1]) -
                                   (side.to[0] - o[0]) * (side.from[1] - o[1]));
    moment += triangle * (o[0] + side.from[0] + side.to[0]) / 3;
    if (!side.arc) continue;
    const Segment segment = segment_of(side);
    moment += segment.area * segment.centroid_x;
  }
  return moment;
}

}  // namespace remeshd
