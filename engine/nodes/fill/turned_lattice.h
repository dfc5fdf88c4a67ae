#pragma once

#include <array>
#include <cstdint>

#include "engine/base/random.h"
#include "engine/base/vec.h"

namespace remeshd {

/// A cubic lattice that is turned against the axes, so that no flat face of a usual model lies
/// along its planes, and shifted by a random offset that depends on a seed.
class TurnedLattice {
 public:
  /// `constant`: side of its cubes, length.
  TurnedLattice(double constant, std::uint64_t seed);

  [[nodiscard]] double constant() const { return a_; }
  /// The point with these lattice coordinates.
  [[nodiscard]] Vec3 place(double u, double v, double w) const {
    return offset_ + a_ * (u * axes_[0] + v * axes_[1] + w * axes_[2]);
  }

  /// Cubes of the lattice from `lo` to `hi`, both included, along each of its axes.
  struct Cubes {
    std::array<long, 3> lo{}, hi{};

    [[nodiscard]] std::size_t layers() const { return hi[2] - lo[2] + 1; }
  };
  /// Cubes that include all that touch a box.
  [[nodiscard]] Cubes cubes_of(const Box& box) const;

  /// The random stream of a place of the lattice: it depends on the place and the seed alone.
  static Random draw(const std::array<long, 3>& place, std::uint64_t seed);

 private:
  double a_;
  Vec3 offset_;
  std::array<Vec3, 3> axes_;
};

}  // namespace remeshd
