#include "engine/nodes/nearest_to_points.h"

#include <utility>

#include "engine/base/parallel.h"

namespace remeshd {

namespace {
constexpr std::size_t kMany = 3;  // where at least one node in so many has moved, no answer is kept
}  // namespace

NearestToPoints::NearestToPoints(std::vector<Vec3> points, double cell)
    : points_(std::move(points)),
      point_grid_(points_, cell),
      reach_(cell),
      answers_(points_.size()),
      node_grid_({}, cell) {}

void NearestToPoints::follow(std::span<const Vec3> nodes) {
  ++now_;
  std::vector<std::int32_t> moved;
  const std::size_t known = nodes_.size();
  nodes_.resize(nodes.size());
  moved_.resize(nodes.size(), 0);
  is_behind_.resize(nodes.size(), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (n < known && nodes_[n] == nodes[n]) continue;
    nodes_[n] = nodes[n];
    moved_[n] = now_;
    moved.push_back(static_cast<std::int32_t>(n));
    if (is_behind_[n] == 0) behind_.push_back(static_cast<std::int32_t>(n));
    is_behind_[n] = 1;
  }
  if (moved.size() * kMany >= nodes.size())
    all_moved_ = now_;
  else
    for (const std::int32_t n : moved) look_again_near(n);
  // So that answers given from now on are later than these moves.
  ++now_;
}

void NearestToPoints::look_again_near(std::int32_t node) {
  point_grid_.for_each_within(nodes_[node], reach_, [&](std::int32_t point, double d) {
    Answer& a = answers_[point];
    if (a.given <= all_moved_ || d > a.distance2 || (d == a.distance2 && node > a.node)) return;
    a = {node, now_, d};
  });
}

NearestToPoints::Answer NearestToPoints::look_up(const NearestNode& grid,
                                                 std::uint32_t point) const {
  const std::int32_t node = grid.nearest(points_[point], answers_[point].node);
  if (node < 0) return {};
  const double d = norm2(nodes_[node] - points_[point]);
  return {node, d <= reach_ * reach_ ? now_ : 0, d};
}

std::int32_t NearestToPoints::nearest(std::uint32_t point) {
  Answer& a = answers_[point];
  if (!stands(a)) a = look_up(grid_of_nodes(), point);
  return a.node;
}

std::vector<std::int32_t> NearestToPoints::nearest(std::span<const std::uint32_t> points,
                                                   const Run& run) {
  const NearestNode& grid = grid_of_nodes();
  std::vector<std::int32_t> nodes(points.size());
  in_blocks(points.size(), kDearBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (std::size_t k = begin; k < end; ++k) {
      Answer& a = answers_[points[k]];
      if (!stands(a)) a = look_up(grid, points[k]);
      nodes[k] = a.node;
    }
  });
  return nodes;
}

const NearestNode& NearestToPoints::grid_of_nodes() {
  node_grid_.follow(nodes_, behind_);
  for (const std::int32_t n : behind_) is_behind_[n] = 0;
  behind_.clear();
  return node_grid_;
}

}  // namespace remeshd
