#pragma once

#include "engine/base/random.h"
#include "engine/base/vec.h"

namespace remeshd::test {

/// A point of the cube [-size, size]^3.
inline Vec3 random_point(Random& random, double size) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

/// A rigid frame turned any way, its origin in [-10, 10]^3.
inline Transform random_frame(Random& random) {
  Vec3 z = random_point(random, 1);
  while (norm(z) < 0.1) z = random_point(random, 1);
  z = normalised(z);
  const double turn = random.uniform(0, 6.28);
  const Vec3 u = any_perpendicular(z), v = cross(z, u);
  const Vec3 x = normalised(std::cos(turn) * u + std::sin(turn) * v);
  return Transform::frame(x, cross(z, x), z, random_point(random, 10));
}

}  // namespace remeshd::test
