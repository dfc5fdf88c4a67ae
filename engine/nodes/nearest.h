#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// Nearest-node queries over a uniform grid whose cells are about one edge length wide. Cheap
/// enough to rebuild whenever nodes have moved.
class NearestNode {
 public:
  /// `cell`: width of a grid cell, > 0. `positions` is copied into cell order.
  NearestNode(std::span<const Vec3> positions, double cell);

  /// The node nearest to p, the lowest index where several are equally near; -1 if there are none.
  [[nodiscard]] std::int32_t nearest(const Vec3& p) const;

  /// Calls f(node, squared distance) for every node within `radius` of p, by cells.
  template <class F>
  void for_each_within(const Vec3& p, double radius, F&& f) const {
    const auto lo = cell_of(p - Vec3{radius, radius, radius});
    const auto hi = cell_of(p + Vec3{radius, radius, radius});
    for (int z = lo[2]; z <= hi[2]; ++z)
      for (int y = lo[1]; y <= hi[1]; ++y)
        for (int x = lo[0]; x <= hi[0]; ++x) {
          const std::size_t c = index(x, y, z);
          for (std::uint32_t k = begin_[c]; k < begin_[c + 1]; ++k) {
            const double d = norm2(points_[k] - p);
            if (d <= radius * radius) f(nodes_[k], d);
          }
        }
  }

 private:
  [[nodiscard]] std::array<int, 3> cell_of(const Vec3& p) const;
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x;
  }

  Box box_;
  double cell_;
  std::array<int, 3> size_{0, 0, 0};
  std::vector<std::uint32_t> begin_;  ///< first entry of each cell, one more at the end
  std::vector<std::int32_t> nodes_;   ///< by cell, ascending within one
  std::vector<Vec3> points_;          ///< of nodes_
};

}  // namespace remeshd
