#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/base/vec.h"

namespace remeshd {

/// Parts of bounding volume hierarchies.

/// Square of the distance of p to a box.
inline double distance2(const Box& box, const Vec3& p) {
  return norm2({std::max({box.lo.x - p.x, p.x - box.hi.x, 0.0}),
                std::max({box.lo.y - p.y, p.y - box.hi.y, 0.0}),
                std::max({box.lo.z - p.z, p.z - box.hi.z, 0.0})});
}

inline Vec3 middle_of(const Box& box) { return 0.5 * (box.lo + box.hi); }

/// Moves the half of the things to the front whose middles are lower along the longest side of the
/// box round all middles. Returns how many these are.
template <class Thing, class Middle>
std::size_t halve(std::span<Thing> things, const Middle& middle) {
  Box middles;
  for (const Thing& thing : things) middles.add(middle(thing));
  const Vec3 sides = middles.hi - middles.lo;
  const double longest = std::max({sides.x, sides.y, sides.z});
  const auto axis = sides.x == longest ? &Vec3::x : sides.y == longest ? &Vec3::y : &Vec3::z;
  const std::size_t half = things.size() / 2;
  std::ranges::nth_element(things, things.begin() + static_cast<std::ptrdiff_t>(half), {},
                           [&](const Thing& thing) { return middle(thing).*axis; });
  return half;
}

}  // namespace remeshd
