#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// Width of a grid's cells, x edge length: fastest for one-nearest queries among nodes this far
/// from each other.
inline constexpr double kGridCell = 0.8;

/// Nearest-node queries over a uniform grid whose cells are about one edge length wide.
class NearestNode {
 public:
  /// `cell`: width of a grid cell, > 0. `positions` is copied into cell order.
  NearestNode(std::span<const Vec3> positions, double cell);

  /// Moves the nodes `moved` to `positions[node]`. New nodes come last in `positions` and have to
  /// be in `moved` too. Cheap where few nodes go far; else the grid is built anew.
  void follow(std::span<const Vec3> positions, std::span<const std::int32_t> moved);

  /// The node nearest to p, the lowest index where several are equally near; -1 if there are none.
  /// `guess`: a node that may be it, which saves time where it is near; -1 for none.
  [[nodiscard]] std::int32_t nearest(const Vec3& p, std::int32_t guess = -1) const;

  /// Whether a node is within `radius` of p. Cheaper than `nearest` where many are.
  [[nodiscard]] bool any_within(const Vec3& p, double radius) const;

  /// Calls f(node, squared distance) for every node within `radius` of p, by cells.
  template <class F>
  void for_each_within(const Vec3& p, double radius, F&& f) const {
    look_within(p, radius, [&](std::int32_t node, const Vec3& at) {
      const double d = norm2(at - p);
      if (d <= radius * radius) f(node, d);
      return false;
    });
  }

 private:
  struct Stray {
    std::int32_t node;
    Vec3 at;
  };

  void build(std::span<const Vec3> positions);
  /// Where a node is.
  [[nodiscard]] const Vec3& place_of(std::int32_t node) const;
  /// How far a point is outside of a cell, along the axis in which it is furthest.
  [[nodiscard]] double beyond(std::uint32_t cell, const Vec3& p) const;
  [[nodiscard]] std::array<int, 3> cell_of(const Vec3& p) const;
  /// Calls look(node, place) for the strays and for what stands in the cells within `radius` of p,
  /// until it returns true; returns whether it did.
  template <class Look>
  bool look_within(const Vec3& p, double radius, const Look& look) const {
    if (nodes_.empty()) return false;  // there are no cells
    for (const auto& [node, at] : strays_)
      if (look(node, at)) return true;
    const double reach = radius + drift_;
    const auto lo = cell_of(p - Vec3{reach, reach, reach});
    const auto hi = cell_of(p + Vec3{reach, reach, reach});
    for (int z = lo[2]; z <= hi[2]; ++z)
      for (int y = lo[1]; y <= hi[1]; ++y)
        if (look_in_row(lo[0], hi[0], y, z, look)) return true;
    return false;
  }
  /// The same for the cells of a row from `first` to `last`, whose entries are contiguous.
  template <class Look>
  bool look_in_row(int first, int last, int y, int z, const Look& look) const {
    const std::uint32_t end = begin_[index(last, y, z) + 1];
    for (std::uint32_t k = begin_[index(first, y, z)]; k < end; ++k)
      if (look(nodes_[k], points_[k])) return true;
    return false;
  }
  /// The same for the cells round p, ring by ring, until look or done(d) returns true; when done(d)
  /// is called, all nodes nearer than d have been looked at.
  template <class Look, class Done>
  void look_round(const Vec3& p, const Look& look, const Done& done) const;
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x;
  }

  Box box_;
  double asked_;  ///< width of a cell asked for
  double cell_;
  double per_length_ = 0;  ///< cells per length
  std::array<int, 3> size_{0, 0, 0};
  std::vector<std::uint32_t> begin_;  ///< first entry of each cell, then the end
  std::vector<std::int32_t> nodes_;   ///< by cell, ascending within one
  std::vector<Vec3> points_;          ///< of nodes_; far away for strays
  std::vector<std::uint32_t> entry_;  ///< by node: its place in nodes_
  std::vector<std::uint32_t> where_;  ///< by node: its cell
  double drift_ = 0;                  ///< no node but the strays is further outside of its cell
  std::vector<Stray> strays_;         ///< nodes that have gone far from their cells
};

}  // namespace remeshd
