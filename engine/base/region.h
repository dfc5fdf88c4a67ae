#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// The neighbourhood of some points, as a set of cubes of a grid.
class Region {
 public:
  /// It holds every place within `reach` of one of the points, and none further than
  /// sqrt(3) * (1 + 1 / steps) * reach from all of them, unless the points are so far apart that
  /// the cubes had to be made larger. `steps`: number of cubes along the reach.
  Region(std::span<const Vec3> points, double reach, int steps);

  [[nodiscard]] bool holds(const Vec3& p) const {
    if (!box_.contains(p)) return false;
    const auto c = cube_of(p);
    return holds_[index(c[0], c[1], c[2])] != 0;
  }
  /// Whether a cube of the set meets the box.
  [[nodiscard]] bool meets(const Box& box) const;
  /// Bounding boxes of the connected components (by common sides of cubes), in a deterministic
  /// order; they may overlap.
  [[nodiscard]] std::vector<Box> boxes() const;

 private:
  [[nodiscard]] std::array<int, 3> cube_of(const Vec3& p) const;
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x;
  }
  void widen(int steps);

  Box box_;  ///< of the whole grid
  double width_ = 0;
  std::array<int, 3> size_{0, 0, 0};
  std::vector<std::uint8_t> holds_;
};

}  // namespace remeshd
