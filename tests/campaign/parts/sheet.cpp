#include "tests/campaign/parts/sheet.h"

#include <algorithm>
#include <cmath>

namespace remeshd::campaign {
namespace {

using Point = std::array<double, 2>;

constexpr double kApart = 0.4;  // of the smaller detail: some more than a wall has to be

double to_segment(const Point& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], n = dx * dx + dy * dy;
  const double along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
  const double t = n == 0 ? 0 : std::clamp(along / n, 0.0, 1.0);
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

double side(const Point& p, const Point& a, const Point& b) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

bool cross_each_other(const Footprint& a, const Footprint& b) {
  return side(a.from, b.from, b.to) * side(a.to, b.from, b.to) < 0 &&
         side(b.from, a.from, a.to) * side(b.to, a.from, a.to) < 0;
}

}  // namespace

double gap(const Footprint& a, const Footprint& b) {
  const double far =
      cross_each_other(a, b)
          ? 0
          : std::min({to_segment(a.from, b.from, b.to), to_segment(a.to, b.from, b.to),
                      to_segment(b.from, a.from, a.to), to_segment(b.to, a.from, a.to)});
  return far - a.radius - b.radius;
}

bool Sheet::has_room(std::span<const Footprint> wanted) const {
  for (const Footprint& f : wanted) {
    const double reach = f.radius + kApart * f.detail;
    for (const Point& p : {f.from, f.to}) {
      if (radius > 0 && std::hypot(p[0], p[1]) + reach > radius) return false;
      if (radius == 0 && (std::fabs(p[0]) + reach > half_x || std::fabs(p[1]) + reach > half_y))
        return false;
    }
    if (inner > 0 && to_segment({0, 0}, f.from, f.to) < inner + reach) return false;
    for (const Footprint& other : taken)
      if (gap(f, other) < kApart * std::min(f.detail, other.detail)) return false;
  }
  return true;
}

}  // namespace remeshd::campaign
