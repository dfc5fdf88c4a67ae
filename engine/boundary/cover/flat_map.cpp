#include "engine/boundary/cover/flat_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace remeshd {
namespace {

using std::numbers::pi;

struct FlatMapLimits {
  double least_gap = 2.2;   ///< rad: points that leave more of a circle do not go round it
  double most_growth = 12;  ///< natural logarithm of a ring's outer radius by its inner one
  double most_power = 3;    ///< growth of a cone's ring that reaches its apex, at most
};
constexpr FlatMapLimits kFlatMapLimits;

/// The middle of the widest gap between angles, if it is wide enough.
std::optional<double> gap_of(std::vector<double> angles) {
  std::ranges::sort(angles);
  double widest = 0, middle = 0;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const bool last = k + 1 == angles.size();
    const double gap = (last ? angles.front() + 2 * pi : angles[k + 1]) - angles[k];
    if (gap <= widest) continue;
    widest = gap;
    middle = angles[k] + 0.5 * gap;
  }
  if (widest < kFlatMapLimits.least_gap) return std::nullopt;
  return middle;
}

/// The angle, counted from a cut on.
double from_cut(double angle, double cut) {
  const double turn = std::fmod(angle - cut, 2 * pi);
  return turn < 0 ? turn + 2 * pi : turn;
}

/// How fast a ring may grow with a height over this range; at most `wanted`.
double growth_for(double wanted, double range) {
  return std::fmin(wanted, range > 0 ? kFlatMapLimits.most_growth / range : wanted);
}

}  // namespace

FlatMap::Parameters FlatMap::parameters(const Vec3& p) const {
  const Vec3 q = to_local_.apply(p);
  const double radius = std::hypot(q.x, q.y), round = std::atan2(q.y, q.x);
  if (surface_.kind == Surface::Kind::Cylinder) return {round, q.z / surface_.r1};
  if (surface_.kind == Surface::Kind::Cone) return {round, radius};
  const double tube = std::atan2(q.z, radius - surface_.r1);
  return swapped_ ? Parameters{tube, round} : Parameters{round, tube};
}

/// Takes for the pole, of 26 directions from the centre, the one furthest from all points.
void FlatMap::fit_pole(std::span<const Vec3> points) {
  double furthest = HUGE_VAL;  // the largest cosine with any of the points
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) {
        if (i == 0 && j == 0 && k == 0) continue;
        const Vec3 axis = normalised(Vec3{double(i), double(j), double(k)});
        double nearest = -1;
        for (const Vec3& p : points)
          nearest = std::fmax(nearest, dot(axis, normalised(to_local_.apply(p))));
        if (nearest >= furthest) continue;
        furthest = nearest;
        const Vec3 other = std::fabs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 u = normalised(cross(axis, other));
        pole_ = {u, cross(axis, u), axis};
      }
}

void FlatMap::fit_ring(std::span<const Vec3> points) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : points) {
    const double h = parameters(p).height;
    const double height = surface_.kind == Surface::Kind::Torus ? from_cut(h, height_cut_) : h;
    low = std::fmin(low, height);
    high = std::fmax(high, height);
  }
  if (surface_.kind == Surface::Kind::Cone) {
    const double sine = std::fabs(surface_.r2) / std::hypot(1, surface_.r2);
    middle_ = high;
    growth_ = low > 1e-9 * high ? growth_for(1 / sine, std::log(high / low))
                                : std::fmin(1 / sine, kFlatMapLimits.most_power);
    return;
  }
  double wanted = 1;
  if (surface_.kind == Surface::Kind::Torus) {
    wanted = surface_.r2 / std::fmax(std::fabs(surface_.r1), surface_.r2);
    if (swapped_) wanted = 1 / wanted;
  }
  middle_ = 0.5 * (low + high);
  growth_ = growth_for(wanted, high - low);
}

bool FlatMap::fit(std::span<const Vec3> points) {
  if (shape_ == Shape::Plane) return true;
  if (shape_ == Shape::Sphere) {
    fit_pole(points);
    return true;
  }
  std::vector<double> angles, heights;
  for (const Vec3& p : points) {
    angles.push_back(parameters(p).angle);
    heights.push_back(parameters(p).height);
  }
  const bool torus = surface_.kind == Surface::Kind::Torus;
  std::optional<double> cut = gap_of(std::move(angles));
  if (torus) {
    std::optional<double> other = gap_of(std::move(heights));
    if (!other && cut) {
      swapped_ = true;
      std::swap(cut, other);
    }
    if (!other) return false;
    height_cut_ = *other;
  }
  if (!cut) {
    fit_ring(points);
    return true;
  }
  shape_ = surface_.kind == Surface::Kind::Cone ? Shape::Sector : Shape::Strip;
  cut_ = *cut;
  growth_ = torus ? surface_.r2 / std::fmax(std::fabs(surface_.r1), surface_.r2) : 1;
  return true;
}

std::optional<FlatMap> FlatMap::of(const Surface& surface, std::span<const Vec3> points) {
  const auto shape = [&] {
    switch (surface.kind) {
      case Surface::Kind::Plane:
        return Shape::Plane;
      case Surface::Kind::Sphere:
        return Shape::Sphere;
      default:
        return Shape::Ring;
    }
  };
  FlatMap map(surface, shape());
  if (!map.fit(points)) return std::nullopt;
  return map;
}

std::array<double, 2> FlatMap::operator()(const Vec3& p) const {
  if (shape_ == Shape::Plane) {
    const Vec3 q = to_local_.apply(p);
    return {q.x, q.y};
  }
  if (shape_ == Shape::Sphere) {  // stereographic
    const Vec3 d = normalised(to_local_.apply(p));
    const double away = std::fmax(1 - dot(d, pole_[2]), 1e-12);
    return {dot(d, pole_[0]) / away, dot(d, pole_[1]) / away};
  }
  auto [angle, height] = parameters(p);
  if (surface_.kind == Surface::Kind::Torus) height = from_cut(height, height_cut_);
  if (shape_ == Shape::Strip) return {from_cut(angle, cut_), height * growth_};
  double radius = 0;
  if (shape_ == Shape::Sector) {  // unrolled
    const double sine = std::fabs(surface_.r2) / std::hypot(1, surface_.r2);
    radius = height / sine;
    angle = from_cut(angle, cut_) * sine;
  } else if (surface_.kind == Surface::Kind::Cone) {
    radius = std::pow(height / middle_, growth_);
  } else {
    radius = std::exp(growth_ * (height - middle_));
  }
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace remeshd
