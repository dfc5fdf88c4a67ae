#include <cmath>
#include <numbers>
#include <optional>

#include "engine/model/profile.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

constexpr double kPi = std::numbers::pi;

Box symmetric(double x, double y, double z_min, double z_max) {
  return {{-x, -y, z_min}, {x, y, z_max}};
}

struct LocalBounds {
  Box operator()(const Block& s) const { return symmetric(s.dx / 2, s.dy / 2, 0, s.dz); }
  Box operator()(const Cylinder& s) const { return symmetric(s.radius, s.radius, 0, s.height); }
  Box operator()(const Cone& s) const {
    const double r = std::fmax(s.radius_bottom, s.radius_top);
    return symmetric(r, r, 0, s.height);
  }
  Box operator()(const Sphere& s) const {
    return symmetric(s.radius, s.radius, -s.radius, s.radius);
  }
  Box operator()(const Torus& s) const {
    const double r = s.major_radius + s.minor_radius;
    return symmetric(r, r, -s.minor_radius, s.minor_radius);
  }
  Box operator()(const Prism& s) const {
    const Box2 outline = profile_bounds(s.profile);
    return {{outline.lo[0], outline.lo[1], 0}, {outline.hi[0], outline.hi[1], s.height}};
  }
  Box operator()(const Revolution& s) const {
    const Box2 outline = profile_bounds(s.profile);
    Box box;
    const auto add_direction = [&](double cosine, double sine) {
      for (const double r : {outline.lo[0], outline.hi[0]})
        for (const double z : {outline.lo[1], outline.hi[1]})
          box.add(Vec3{r * cosine, r * sine, z});
    };
    add_direction(1, 0);
    if (s.angle >= kPi / 2) add_direction(0, 1);
    if (s.angle >= kPi) add_direction(-1, 0);
    if (s.angle >= 3 * kPi / 2) add_direction(0, -1);
    if (s.angle < 2 * kPi) add_direction(std::cos(s.angle), std::sin(s.angle));
    return box;
  }
  Box operator()(const Slot& s) const { return symmetric(s.length / 2, s.width / 2, 0, s.height); }
};

struct Volume {
  double operator()(const Block& s) const { return s.dx * s.dy * s.dz; }
  double operator()(const Cylinder& s) const { return kPi * s.radius * s.radius * s.height; }
  double operator()(const Cone& s) const {
    const double a = s.radius_bottom, b = s.radius_top;
    return kPi / 3 * s.height * (a * a + a * b + b * b);
  }
  double operator()(const Sphere& s) const { return 4 * kPi / 3 * s.radius * s.radius * s.radius; }
  double operator()(const Torus& s) const {
    return 2 * kPi * kPi * s.major_radius * s.minor_radius * s.minor_radius;
  }
  double operator()(const Prism& s) const { return std::fabs(signed_area(s.profile)) * s.height; }
  double operator()(const Revolution& s) const {  // Pappus
    return s.angle * std::fabs(moment_about_axis(s.profile));
  }
  double operator()(const Slot& s) const {
    const double r = s.width / 2;
    return ((s.length - s.width) * s.width + kPi * r * r) * s.height;
  }
};

/// A region about the z axis: between two radii, two heights, and the angles 0 and `angle` (rad)
/// from the x axis.
struct Ring {
  double inner, outer, low, high, angle;
};

/// The ring that a shape lies in; none for shapes that reach their axis.
std::optional<Ring> ring_of(const Shape& shape) {
  if (const auto* s = std::get_if<Torus>(&shape))
    return Ring{s->major_radius - s->minor_radius, s->major_radius + s->minor_radius,
                -s->minor_radius, s->minor_radius, 2 * kPi};
  if (const auto* s = std::get_if<Revolution>(&shape)) {
    const Box2 outline = profile_bounds(s->profile);
    if (outline.lo[0] > 0)
      return Ring{outline.lo[0], outline.hi[0], outline.lo[1], outline.hi[1], s->angle};
  }
  return std::nullopt;
}

// Per full turn. With so many, the box of a sector at 45 degrees to the axes reaches only a
// twentieth of the radius into the hole.
constexpr int kSectors = 64;

}  // namespace

Box local_bounds(const Shape& shape) { return std::visit(LocalBounds{}, shape); }

Box world_bounds(const Feature& feature) {
  return moved(local_bounds(feature.shape), feature.placement);
}

std::vector<Box> boxes_round(const Feature& feature) {
  const auto ring = ring_of(feature.shape);
  if (!ring) return {world_bounds(feature)};
  const int count = static_cast<int>(std::ceil(kSectors * ring->angle / (2 * kPi)));
  const double step = ring->angle / count;
  std::vector<Box> boxes(count);
  for (int i = 0; i < count; ++i) {
    const auto add = [&](double angle, double radius) {
      for (const double z : {ring->low, ring->high})
        boxes[i].add(
            feature.placement.apply({radius * std::cos(angle), radius * std::sin(angle), z}));
    };
    for (const double end : {i * step, (i + 1) * step}) {
      add(end, ring->inner);
      add(end, ring->outer);
    }
    add((i + 0.5) * step, ring->outer / std::cos(step / 2));  // where tangents at the ends meet
  }
  return boxes;
}

double volume_of(const Shape& shape) { return std::visit(Volume{}, shape); }

}  // namespace remeshd
