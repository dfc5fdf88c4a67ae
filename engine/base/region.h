#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// What is near some points, as cubes of a grid.
class Region {
 public:
  /// Everything within `reach` of one of the points is in it, and what is in it is within
  /// sqrt(3) * (1 + 1 / steps) * reach of one, unless the points are so far apart that the cubes
  /// had to be made larger. `steps`: width of the cubes, as a fraction of the reach.
  Region(std::span<const Vec3> points, double reach, int steps);

  [[nodiscard]] bool holds(const Vec3& p) const {
    if (!box_.contains(p)) return false;
    const auto c = cube_of(p);
    return holds_[index(c[0], c[1], c[2])] != 0;
  }
  /// Whether one of the cubes meets the box.
  [[nodiscard]] bool meets(const Box& box) const;
  /// Boxes round the parts that hang together, in an order of their own; they may overlap.
  [[nodiscard]] std::vector<Box> boxes() const;

 private:
  [[nodiscard]] std::array<int, 3> cube_of(const Vec3& p) const;
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x;
  }
  void widen(int steps);

  Box box_;  ///< of all cubes
  double width_ = 0;
  std::array<int, 3> size_{0, 0, 0};
  std::vector<std::uint8_t> holds_;
};

}  // namespace remeshd
