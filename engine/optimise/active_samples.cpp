#include "engine/optimise/active_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace remeshd {

namespace {
constexpr double kBorder = 0.6;    // of the edge length: the next one or two samples of a face
constexpr double kGridCell = 0.8;  // of the edge length
constexpr double kReach = 1.5;     // of the edge length: no node is further from a sample

/// The cubes of a coarse grid that hold a free node, and all those round them: everything within a
/// cube's width of a free node is there.
class Neighbourhood {
 public:
  Neighbourhood(const NodeSet& nodes, double width) {
    for (std::int32_t n = 0; n < nodes.size(); ++n)
      if (nodes.free[n]) box_.add(nodes.positions[n]);
    if (box_.empty()) return;
    const Vec3 extent = box_.hi - box_.lo;
    const double volume = (extent.x + width) * (extent.y + width) * (extent.z + width);
    width_ = std::fmax(width, std::cbrt(volume / kMostCubes));
    for (int a = 0; a < 3; ++a)
      size_[a] = 3 + static_cast<int>((a == 0 ? extent.x : a == 1 ? extent.y : extent.z) / width_);
    holds_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], 0);
    for (std::int32_t n = 0; n < nodes.size(); ++n) {
      if (!nodes.free[n]) continue;
      const auto c = cube_of(nodes.positions[n]);
      for (int z = c[2] - 1; z <= c[2] + 1; ++z)
        for (int y = c[1] - 1; y <= c[1] + 1; ++y)
          for (int x = c[0] - 1; x <= c[0] + 1; ++x) holds_[index(x, y, z)] = 1;
    }
  }

  [[nodiscard]] bool holds(const Vec3& p) const {
    if (box_.empty() || !box_.contains(p, width_)) return false;
    const auto c = cube_of(p);
    return holds_[index(c[0], c[1], c[2])] != 0;
  }

 private:
  static constexpr double kMostCubes = 1e7;  // bound on memory

  /// 1-based within the box: there is a layer of cubes round it.
  [[nodiscard]] std::array<int, 3> cube_of(const Vec3& p) const {
    const auto axis = [&](double v, double lo, int n) {
      return std::clamp(1 + static_cast<int>(std::floor((v - lo) / width_)), 0, n - 1);
    };
    return {axis(p.x, box_.lo.x, size_[0]), axis(p.y, box_.lo.y, size_[1]),
            axis(p.z, box_.lo.z, size_[2])};
  }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x;
  }

  Box box_;
  double width_ = 0;
  std::array<int, 3> size_{0, 0, 0};
  std::vector<std::uint8_t> holds_;
};

}  // namespace

ActiveSamples::ActiveSamples(const Samples& samples)
    : states_(samples.points.size(), State::Active),
      participants_(samples.points.size()),
      active_count_(static_cast<std::uint32_t>(samples.points.size())) {
  std::iota(participants_.begin(), participants_.end(), 0U);
}

ActiveSamples::ActiveSamples(const Samples& samples, const NodeSet& nodes, double edge_length)
    : edge_length_(edge_length), states_(samples.points.size(), State::Resting) {
  positions_.reserve(samples.points.size());
  for (const Sample& s : samples.points) positions_.push_back(s.position);
  grid_.emplace_back(positions_, kGridCell * edge_length);
  refresh(nodes);
}

void ActiveSamples::refresh(const NodeSet& nodes) {
  if (grid_.empty()) return;
  // Samples far from every free node cannot have one nearest.
  const Neighbourhood near_free(nodes, kReach * edge_length_);
  const NearestNode grid(nodes.positions, kGridCell * edge_length_);
  for (std::uint32_t s = 0; s < states_.size(); ++s) {
    if (states_[s] == State::Active || !near_free.holds(positions_[s])) continue;
    const std::int32_t node = grid.nearest(positions_[s]);
    if (node >= 0 && nodes.free[node]) activate(s);
  }
  collect();
}

void ActiveSamples::promote(std::span<const std::uint32_t> pulling) {
  if (grid_.empty()) return;
  bool changed = false;
  for (const std::uint32_t s : pulling) {
    if (states_[s] == State::Active) continue;
    activate(s);
    changed = true;
  }
  if (changed) collect();
}

void ActiveSamples::activate(std::uint32_t sample) {
  states_[sample] = State::Active;
  grid_.front().for_each_within(positions_[sample], kBorder * edge_length_,
                                [&](std::int32_t other, double) {
                                  if (states_[other] == State::Resting)
                                    states_[other] = State::Border;
                                });
}

void ActiveSamples::collect() {
  participants_.clear();
  active_count_ = 0;
  for (std::uint32_t s = 0; s < states_.size(); ++s) {
    if (states_[s] != State::Resting) participants_.push_back(s);
    if (states_[s] == State::Active) ++active_count_;
  }
}

}  // namespace remeshd
