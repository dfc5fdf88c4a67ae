#include "engine/local_fuse/arrangement/patches.h"

#include <cmath>

#include "engine/base/angle.h"

namespace remeshd {
namespace {

/// Adds the box of a circle about a unit axis.
void add_circle(Box& box, const Vec3& centre, const Vec3& axis, double radius) {
  const auto reach = [&](double a) { return radius * std::sqrt(std::max(0.0, 1 - a * a)); };
  const Vec3 r{reach(axis.x), reach(axis.y), reach(axis.z)};
  box.add(centre - r);
  box.add(centre + r);
}

class Collector {
 public:
  explicit Collector(Patches& out) : out_(out) {}

  void add(const Sweep& sweep, const Transform& frame) {
    sweep_ = &sweep;
    frame_ = &frame;
    for (const bool top : {false, true}) add_cap(top);
    for (const SweepSide& side : sweep.sides) side.round ? add_round(side) : add_flat(side);
  }

 private:
  [[nodiscard]] Vec3 at(const Vec3& p, bool top) const {
    return frame_->apply({p.x, p.y, top ? sweep_->high : sweep_->low});
  }
  Patch& add_patch(const SolidFace* face) {
    Patch& patch = out_.patches.emplace_back();
    patch.feature = sweep_->feature;
    patch.face = face;
    return patch;
  }
  void add_edge(const Vec3& from, const Vec3& to, int wall = -1, int seam = -1) {
    out_.edges.push_back({sweep_->feature, from, to, wall, seam});
  }
  static void set_plane(Patch& patch) {
    patch.origin = patch.face->surface.frame.apply({0, 0, 0});
    patch.normal = patch.face->surface.frame.rotate({0, 0, 1});
  }

  void add_cap(bool top) {
    Patch& patch = add_patch(top ? sweep_->top : sweep_->bottom);
    patch.cap = true;
    set_plane(patch);
    for (const SweepSide& side : sweep_->sides) {
      patch.box.add(at(side.from, top));
      if (side.round) add_circle(patch.box, at(side.centre, top), patch.normal, side.radius);
    }
  }

  void add_flat(const SweepSide& side) {
    Patch& patch = add_patch(side.face);
    set_plane(patch);
    patch.from = at(side.from, false);
    patch.length = distance(side.from, side.to);
    patch.along = frame_->rotate(side.to - side.from) / patch.length;
    for (const bool top : {false, true}) {
      patch.box.add(at(side.from, top));
      patch.box.add(at(side.to, top));
      add_edge(at(side.from, top), at(side.to, top));
    }
    add_edge(at(side.from, false), at(side.from, true));
  }

  void add_round(const SweepSide& side) {
    const int number = static_cast<int>(out_.patches.size());
    Patch& patch = add_patch(side.face);
    patch.round = true;
    patch.radius = side.face->surface.r1;
    patch.into = rigid_inverse(side.face->surface.frame);
    const double a = patch.into.apply(at(side.centre, false)).z;
    const double b = patch.into.apply(at(side.centre, true)).z;
    patch.low = std::min(a, b);
    patch.high = std::max(a, b);
    patch.angle = kTurn;
    for (const bool top : {false, true})
      add_circle(patch.box, at(side.centre, top), patch.axis(), patch.radius);
    if (side.closed()) {
      // The seam, where the CAD kernel has it.
      const Transform& own = side.face->surface.frame;
      const Vec3 low = own.apply({patch.radius, 0, patch.low});
      const Vec3 high = own.apply({patch.radius, 0, patch.high});
      for (const Vec3& end : {low, high}) add_edge(end, end, number);
      add_edge(low, high, -1, number);
      return;
    }
    // From the end from which the wall goes counter-clockwise about its axis.
    const Vec3 from = at(side.from, false), to = at(side.to, false);
    const Vec3 turning = frame_->rotate({0, 0, side.left_turn ? 1.0 : -1.0});
    const bool same_way = dot(turning, patch.axis()) > 0;
    patch.first = patch.angle_at(same_way ? from : to);
    patch.angle = patch.angle_at(same_way ? to : from);
    for (const bool top : {false, true}) add_edge(at(side.from, top), at(side.to, top), number);
    add_edge(from, at(side.from, true));
  }

  Patches& out_;
  const Sweep* sweep_ = nullptr;
  const Transform* frame_ = nullptr;
};

}  // namespace

bool Patch::closed() const { return round && angle == kTurn; }

double Patch::distance_to(const Vec3& p) const {
  if (!round) return dot(p - origin, normal);
  const Vec3 q = into.apply(p);
  return std::hypot(q.x, q.y) - radius;
}

Vec3 Patch::normal_at(const Vec3& p) const {
  if (!round) return normal;
  const Vec3 q = into.apply(p);
  const double r = std::hypot(q.x, q.y);
  return rigid_inverse(into).rotate({q.x / r, q.y / r, 0});
}

double Patch::angle_at(const Vec3& p) const {
  const Vec3 q = into.apply(p);
  return wrapped(std::atan2(q.y, q.x) - first);
}

bool Patch::beside(const Vec3& p, double tolerance) const {
  if (cap || closed()) return true;
  if (!round) {
    const double s = dot(p - from, along);
    return s >= -tolerance && s <= length + tolerance;
  }
  const double beyond = angle_at(p);
  return beyond <= angle + tolerance / radius || beyond >= kTurn - tolerance / radius;
}

Tried<Patches> find_patches(const FeatureModel& model, const Membership& membership,
                            std::span<const int> features) {
  Patches out;
  Collector collector(out);
  for (const int f : features) {
    const auto alone = find_sweeps(model, membership, std::span(&f, 1));
    if (!alone) return alone.why();
    collector.add(alone->sweeps.front(), alone->frame);
  }
  return out;
}

}  // namespace remeshd
