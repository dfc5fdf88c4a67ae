#include "engine/nodes/nearest.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerance.h"

namespace remeshd {

namespace {
struct GridLimits {
  double per_node = 64;          ///< cells: bound on memory where nodes are few and far between
  double drift = 0.15;           ///< x width of a cell: a node further outside of it is a stray
  std::size_t most_strays = 12;  ///< each query looks at all of them
};
constexpr GridLimits kGridLimits;
constexpr Vec3 kAway{1e150, 1e150, 1e150};
}  // namespace

NearestNode::NearestNode(std::span<const Vec3> positions, double cell) : asked_(cell), cell_(cell) {
  build(positions);
}

void NearestNode::build(std::span<const Vec3> positions) {
  box_ = {};
  cell_ = asked_;
  drift_ = 0;
  strays_.clear();
  for (const Vec3& p : positions) box_.add(p);
  if (positions.empty()) return;
  const Vec3 extent = box_.hi - box_.lo;
  const auto cells = [&] {
    return (extent.x / cell_ + 1) * (extent.y / cell_ + 1) * (extent.z / cell_ + 1);
  };
  while (cells() > kGridLimits.per_node * static_cast<double>(positions.size()) + 64) cell_ *= 1.3;
  size_ = {static_cast<int>(extent.x / cell_) + 1, static_cast<int>(extent.y / cell_) + 1,
           static_cast<int>(extent.z / cell_) + 1};
  per_length_ = 1 / cell_;
  where_.resize(positions.size());
  begin_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto c = cell_of(positions[i]);
    where_[i] = static_cast<std::uint32_t>(index(c[0], c[1], c[2]));
    ++begin_[where_[i] + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  nodes_.resize(positions.size());
  points_.resize(positions.size());
  entry_.resize(positions.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::uint32_t k = next[where_[i]]++;
    nodes_[k] = static_cast<std::int32_t>(i);
    points_[k] = positions[i];
    entry_[i] = k;
  }
}

double NearestNode::beyond(std::uint32_t cell, const Vec3& p) const {
  const auto axis = [&](double v, double lo, int c) {
    return std::max({lo + c * cell_ - v, v - (lo + (c + 1) * cell_), 0.0});
  };
  const int x = static_cast<int>(cell % size_[0]), yz = static_cast<int>(cell / size_[0]);
  return std::max({axis(p.x, box_.lo.x, x), axis(p.y, box_.lo.y, yz % size_[1]),
                   axis(p.z, box_.lo.z, yz / size_[1])});
}

void NearestNode::follow(std::span<const Vec3> positions, std::span<const std::int32_t> moved) {
  if (nodes_.empty()) {
    build(positions);
    return;
  }
  for (const std::int32_t n : moved) {
    const Vec3& p = positions[n];
    const bool known = static_cast<std::size_t>(n) < entry_.size();
    const double off = known ? beyond(where_[n], p) : HUGE_VAL;
    if (known && off <= kGridLimits.drift * cell_ && points_[entry_[n]] != kAway) {
      points_[entry_[n]] = p;
      drift_ = std::max(drift_, off);
      continue;
    }
    const auto at = std::ranges::find(strays_, n, &Stray::node);
    if (at != strays_.end()) {
      at->at = p;
      continue;
    }
    if (strays_.size() == kGridLimits.most_strays) {
      build(positions);
      return;
    }
    if (known) points_[entry_[n]] = kAway;
    strays_.push_back({n, p});
  }
}

std::array<int, 3> NearestNode::cell_of(const Vec3& p) const {
  const auto axis = [&](double v, double lo, int n) {
    return static_cast<int>(std::clamp((v - lo) * per_length_, 0.0, static_cast<double>(n - 1)));
  };
  return {axis(p.x, box_.lo.x, size_[0]), axis(p.y, box_.lo.y, size_[1]),
          axis(p.z, box_.lo.z, size_[2])};
}

template <class Look, class Done>
void NearestNode::look_round(const Vec3& p, const Look& look, const Done& done) const {
  const auto home = cell_of(p);
  // Distance from p to the box of cells within `ring` of home: nothing beyond can be nearer.
  const auto margin = [&](int ring) {
    double m = HUGE_VAL;
    const std::array<double, 3> v{p.x - box_.lo.x, p.y - box_.lo.y, p.z - box_.lo.z};
    for (int a = 0; a < 3; ++a) {
      if (home[a] - ring > 0) m = std::min(m, v[a] - (home[a] - ring) * cell_);
      if (home[a] + ring < size_[a] - 1) m = std::min(m, (home[a] + ring + 1) * cell_ - v[a]);
    }
    return m - drift_;
  };
  for (const auto& [node, at] : strays_)
    if (look(node, at)) return;
  for (int ring = 0;; ++ring) {
    const int x0 = std::max(home[0] - ring, 0), x1 = std::min(home[0] + ring, size_[0] - 1);
    const int y0 = std::max(home[1] - ring, 0), y1 = std::min(home[1] + ring, size_[1] - 1);
    const int z0 = std::max(home[2] - ring, 0), z1 = std::min(home[2] + ring, size_[2] - 1);
    for (int z = z0; z <= z1; ++z)
      for (int y = y0; y <= y1; ++y) {
        const bool shell = z == home[2] - ring || z == home[2] + ring || y == home[1] - ring ||
                           y == home[1] + ring;
        // Inside the shell only its two ends in x are new to this ring.
        if (shell ? look_in_row(x0, x1, y, z, look)
                  : (home[0] - ring == x0 && look_in_row(x0, x0, y, z, look)) ||
                        (home[0] + ring == x1 && look_in_row(x1, x1, y, z, look)))
          return;
      }
    if (done(margin(ring))) return;
  }
}

const Vec3& NearestNode::place_of(std::int32_t node) const {
  const auto stray = std::ranges::find(strays_, node, &Stray::node);
  return stray != strays_.end() ? stray->at : points_[entry_[node]];
}

std::int32_t NearestNode::nearest(const Vec3& p, std::int32_t guess) const {
  if (nodes_.empty()) return -1;
  std::int32_t best = -1;
  double best_d = HUGE_VAL;
  const auto look = [&](std::int32_t node, const Vec3& at) {
    const double d = norm2(at - p);
    if (d > best_d || (d == best_d && node > best)) return false;
    best_d = d;
    best = node;
    return false;
  };
  if (guess >= 0) look(guess, place_of(guess));
  if (best_d <= cell_ * cell_)
    look_within(p, (1 + tolerance::kRounding) * std::sqrt(best_d), look);
  else
    look_round(p, look, [&](double seen) {
      return best >= 0 && (seen == HUGE_VAL || (seen > 0 && seen * seen > best_d));
    });
  return best;
}

bool NearestNode::any_within(const Vec3& p, double radius) const {
  return look_within(
      p, radius, [&](std::int32_t, const Vec3& at) { return norm2(at - p) <= radius * radius; });
}

}  // namespace remeshd
