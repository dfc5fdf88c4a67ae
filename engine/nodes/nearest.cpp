#include "engine/nodes/nearest.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {
constexpr double kCellsPerNode = 64;  // bound on memory where nodes are few and far between
}

NearestNode::NearestNode(std::span<const Vec3> positions, double cell) : cell_(cell) {
  for (const Vec3& p : positions) box_.add(p);
  if (positions.empty()) return;
  const Vec3 extent = box_.hi - box_.lo;
  const auto cells = [&] {
    return (extent.x / cell_ + 1) * (extent.y / cell_ + 1) * (extent.z / cell_ + 1);
  };
  while (cells() > kCellsPerNode * static_cast<double>(positions.size()) + 64) cell_ *= 1.3;
  size_ = {static_cast<int>(extent.x / cell_) + 1, static_cast<int>(extent.y / cell_) + 1,
           static_cast<int>(extent.z / cell_) + 1};
  std::vector<std::uint32_t> where(positions.size());
  begin_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto c = cell_of(positions[i]);
    where[i] = static_cast<std::uint32_t>(index(c[0], c[1], c[2]));
    ++begin_[where[i] + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  nodes_.resize(positions.size());
  points_.resize(positions.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t k = next[where[i]]++;
    nodes_[k] = static_cast<std::int32_t>(i);
    points_[k] = positions[i];
  }
}

std::array<int, 3> NearestNode::cell_of(const Vec3& p) const {
  const auto axis = [&](double v, double lo, int n) {
    return static_cast<int>(std::clamp((v - lo) / cell_, 0.0, static_cast<double>(n - 1)));
  };
  return {axis(p.x, box_.lo.x, size_[0]), axis(p.y, box_.lo.y, size_[1]),
          axis(p.z, box_.lo.z, size_[2])};
}

std::int32_t NearestNode::nearest(const Vec3& p) const {
  if (nodes_.empty()) return -1;
  const auto home = cell_of(p);
  // Distance from p to the box of cells within `ring` of home: nothing beyond can be nearer.
  const auto margin = [&](int ring) {
    double m = HUGE_VAL;
    const std::array<double, 3> v{p.x - box_.lo.x, p.y - box_.lo.y, p.z - box_.lo.z};
    for (int a = 0; a < 3; ++a) {
      if (home[a] - ring > 0) m = std::min(m, v[a] - (home[a] - ring) * cell_);
      if (home[a] + ring < size_[a] - 1) m = std::min(m, (home[a] + ring + 1) * cell_ - v[a]);
    }
    return m;
  };
  std::int32_t best = -1;
  double best_d = HUGE_VAL;
  for (int ring = 0;; ++ring) {
    const int x0 = std::max(home[0] - ring, 0), x1 = std::min(home[0] + ring, size_[0] - 1);
    const int y0 = std::max(home[1] - ring, 0), y1 = std::min(home[1] + ring, size_[1] - 1);
    const int z0 = std::max(home[2] - ring, 0), z1 = std::min(home[2] + ring, size_[2] - 1);
    for (int z = z0; z <= z1; ++z)
      for (int y = y0; y <= y1; ++y) {
        const bool shell = z == home[2] - ring || z == home[2] + ring || y == home[1] - ring ||
                           y == home[1] + ring;
        // Inside the shell only its two ends in x are new to this ring.
        const int step = shell || ring == 0 ? 1 : 2 * ring;
        for (int x = shell ? x0 : home[0] - ring; x <= x1; x += step) {
          if (x < x0) continue;
          const std::size_t c = index(x, y, z);
          for (std::uint32_t k = begin_[c]; k < begin_[c + 1]; ++k) {
            const double d = norm2(points_[k] - p);
            if (d < best_d || (d == best_d && nodes_[k] < best)) {
              best_d = d;
              best = nodes_[k];
            }
          }
        }
      }
    const double m = margin(ring);
    if (best >= 0 && (m == HUGE_VAL || (m > 0 && m * m >= best_d))) return best;
  }
}

}  // namespace remeshd
