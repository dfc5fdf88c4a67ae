#include "engine/model/solid.h"

#include <cmath>
#include <numbers>

#include "engine/base/angle.h"

namespace remeshd {
namespace {

double square(double x) { return x * x; }

}  // namespace

Solid::Solid(const Feature& feature)
    : bounds_(world_bounds(feature)), faces_(faces_of(feature)), volume_(volume_of(feature.shape)) {
  const auto& m = feature.placement.m;
  origin_ = {m[3], m[7], m[11]};
  axis_x_ = {m[0], m[4], m[8]};
  axis_y_ = {m[1], m[5], m[9]};
  axis_z_ = {m[2], m[6], m[10]};
  rotated_ = axis_x_ != Vec3{1, 0, 0} || axis_y_ != Vec3{0, 1, 0} || axis_z_ != Vec3{0, 0, 1};
  prepare(feature.shape);
}

void Solid::prepare(const Shape& shape) {
  form_ = static_cast<Form>(shape.index());
  const std::vector<ProfileSide>* profile = nullptr;
  if (const auto* s = std::get_if<Block>(&shape)) {
    a_ = s->dx / 2, b_ = s->dy / 2, c_ = s->dz;
  } else if (const auto* s1 = std::get_if<Cylinder>(&shape)) {
    a_ = square(s1->radius), c_ = s1->height;
  } else if (const auto* s2 = std::get_if<Cone>(&shape)) {
    a_ = s2->radius_bottom, b_ = (s2->radius_top - s2->radius_bottom) / s2->height, c_ = s2->height;
  } else if (const auto* s3 = std::get_if<Sphere>(&shape)) {
    a_ = square(s3->radius);
  } else if (const auto* s4 = std::get_if<Torus>(&shape)) {
    a_ = s4->major_radius, b_ = square(s4->minor_radius);
  } else if (const auto* s5 = std::get_if<Prism>(&shape)) {
    profile = &s5->profile, c_ = s5->height;
  } else if (const auto* s6 = std::get_if<Revolution>(&shape)) {
    profile = &s6->profile;
    full_turn_ = s6->angle >= kTurn;
    reflex_ = s6->angle > std::numbers::pi;
    end_cos_ = std::cos(s6->angle), end_sin_ = std::sin(s6->angle);
  } else if (const auto* s7 = std::get_if<Slot>(&shape)) {
    a_ = (s7->length - s7->width) / 2, b_ = square(s7->width / 2), c_ = s7->height;
  }
  if (profile == nullptr) return;
  for (const ProfileSide& side : *profile)
    outline_.push_back({side.from[0], side.from[1], side.to[0] - side.from[0],
                        side.to[1] - side.from[1], side.to[1], side.arc, side.counter_clockwise,
                        side.centre[0], side.centre[1], square(side.radius)});
}

bool Solid::contains(const Vec3& p) const {
  if (!bounds_.contains(p)) return false;
  const Vec3 d = p - origin_;
  return contains_local(rotated_ ? Vec3{dot(axis_x_, d), dot(axis_y_, d), dot(axis_z_, d)} : d);
}

bool Solid::contains_local(const Vec3& q) const {
  switch (form_) {
    case Form::Block:
      return std::fabs(q.x) <= a_ && std::fabs(q.y) <= b_ && q.z >= 0 && q.z <= c_;
    case Form::Cylinder:
      return q.z >= 0 && q.z <= c_ && q.x * q.x + q.y * q.y <= a_;
    case Form::Cone:
      return q.z >= 0 && q.z <= c_ && q.x * q.x + q.y * q.y <= square(a_ + b_ * q.z);
    case Form::Sphere:
      return norm2(q) <= a_;
    case Form::Torus:
      return square(std::sqrt(q.x * q.x + q.y * q.y) - a_) + q.z * q.z <= b_;
    case Form::Prism:
      return q.z >= 0 && q.z <= c_ && outline_contains(q.x, q.y);
    case Form::Revolution:
      return (full_turn_ || within_angle(q.x, q.y)) &&
             outline_contains(std::sqrt(q.x * q.x + q.y * q.y), q.z);
    case Form::Slot: {
      const double beyond = std::fmax(std::fabs(q.x) - a_, 0);
      return q.z >= 0 && q.z <= c_ && beyond * beyond + q.y * q.y <= b_;
    }
  }
  return false;
}

bool Solid::outline_contains(double x, double y) const {
  // Crossings of the ray towards +x with the polygon of the chords; each arc then swaps inside and
  // outside in the segment between it and its chord. Both look at the same side of the chord, so
  // that a point on a chord is not lost between them.
  bool inside = false;
  for (const OutlineSide& s : outline_) {
    const double up = y - s.y;
    const bool start_above = up<0, end_above = s.end_y> y;
    const bool spans = start_above != end_above;
    if (!spans && !s.arc) continue;
    const double turn = s.dx * up - s.dy * (x - s.x);
    const bool left = turn > 0 || (turn == 0 && !spans && (start_above ? s.dx < 0 : s.dx > 0));
    if (spans && left == end_above) inside = !inside;
    if (s.arc && left != s.bulges_right &&
        square(x - s.centre_x) + square(y - s.centre_y) <= s.radius2)
      inside = !inside;
  }
  return inside;
}

bool Solid::within_angle(double x, double y) const {
  const bool after_start = y >= 0;
  const bool before_end = end_sin_ * x - end_cos_ * y >= 0;
  return reflex_ ? after_start || before_end : after_start && before_end;
}

}  // namespace remeshd
