#include "engine/nodes/fill/turned_lattice.h"

#include <cmath>

namespace remeshd {

TurnedLattice::TurnedLattice(double constant, std::uint64_t seed) : a_(constant) {
  Random random(seed);
  offset_ = a_ * Vec3{random.uniform(), random.uniform(), random.uniform()};
  // Turned by .5 rad about z, then by .7 rad about the new x axis.
  const double c = std::cos(0.5), s = std::sin(0.5), d = std::cos(0.7), e = std::sin(0.7);
  axes_ = {Vec3{c, s, 0}, Vec3{-s * d, c * d, e}, Vec3{s * e, -c * e, d}};
}

TurnedLattice::Cubes TurnedLattice::cubes_of(const Box& box) const {
  Cubes cubes;
  for (int i = 0; i < 3; ++i) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p{corner & 1 ? box.lo.x : box.hi.x, corner & 2 ? box.lo.y : box.hi.y,
                   corner & 4 ? box.lo.z : box.hi.z};
      const double along = dot(p - offset_, axes_[i]) / a_;
      least = std::fmin(least, along);
      most = std::fmax(most, along);
    }
    cubes.lo[i] = static_cast<long>(std::floor(least)) - 1;
    cubes.hi[i] = static_cast<long>(std::ceil(most)) + 1;
  }
  return cubes;
}

Random TurnedLattice::draw(const std::array<long, 3>& place, std::uint64_t seed) {
  const auto mix = [](long v, std::uint64_t factor) {
    return static_cast<std::uint64_t>(v) * factor;
  };
  return Random(seed ^
                (mix(place[0], 0x9E3779B97F4A7C15ULL) + mix(place[1], 0xC2B2AE3D27D4EB4FULL) +
                 mix(place[2], 0x165667B19E3779F9ULL)));
}

}  // namespace remeshd
