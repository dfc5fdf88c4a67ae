#include "engine/nodes/surroundings.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {
struct SurroundingsGrid {
  int steps = 4;        ///< cubes of the region along the reach
  double cell = 0.4;    ///< width of the grid's cells, x the reach
  double slack = 1e-9;  ///< of a radius or the reach: more than rounding
};
constexpr SurroundingsGrid kGrid;
}  // namespace

Surroundings::Surroundings(std::span<const Vec3> points, double reach, const Box& within)
    : reach_(reach), region_(points, reach, kGrid.steps), grid_(points, kGrid.cell * reach) {
  for (const Box& part : region_.boxes()) {
    parts_.push_back(grown(part, kGrid.slack * reach));
    const Box box = intersection(part, within);
    if (box.empty()) continue;
    boxes_.push_back(box);
    box_.add(box);
  }
}

bool Surroundings::holds(const Vec3& p) const {
  return region_.holds(p) && grid_.any_within(p, reach_);
}

bool Surroundings::may_hold_some_of(const Box& box) const {
  return std::ranges::any_of(parts_,
                             [&](const Box& part) { return !intersection(part, box).empty(); });
}

bool Surroundings::meets(const Vec3& centre, double radius) const {
  if (box_.empty()) return false;
  if (!std::isfinite(radius)) return true;
  const double reached2 = radius * radius * (1 + kGrid.slack);
  const auto near = [&](const Box& box) {
    const Vec3 nearest{std::clamp(centre.x, box.lo.x, box.hi.x),
                       std::clamp(centre.y, box.lo.y, box.hi.y),
                       std::clamp(centre.z, box.lo.z, box.hi.z)};
    return norm2(nearest - centre) <= reached2;
  };
  return near(box_) && std::ranges::any_of(boxes_, near);
}

}  // namespace remeshd
