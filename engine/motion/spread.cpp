#include "engine/motion/spread.h"

#include <algorithm>
#include <cmath>

namespace remeshd {
namespace {

struct SolverLimits {
  double tolerance = 1e-12;  ///< of the residual, relative to that of x = 0
  double rough = 1e-3;       ///< of the residual, relative to that at the beginning
  int iterations = 2000;
};
constexpr SolverLimits kSolver;

double product(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
  return sum;
}

}  // namespace

Spread::Spread(std::span<const std::int32_t> nodes, std::span<const MotionLink> links,
               std::size_t all)
    : nodes_(nodes.begin(), nodes.end()),
      row_(all, -1),
      begin_(nodes.size() + 1, 0),
      diagonal_(nodes.size(), 0) {
  for (std::size_t k = 0; k < nodes_.size(); ++k) row_[nodes_[k]] = static_cast<std::int32_t>(k);
  for (const MotionLink& link : links)
    for (const std::int32_t n : {link.a, link.b})
      if (row_[n] >= 0) ++begin_[row_[n] + 1];
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  entries_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const MotionLink& link : links) {
    if (row_[link.a] >= 0) entries_[next[row_[link.a]]++] = {link.b, row_[link.b], link.weight};
    if (row_[link.b] >= 0) entries_[next[row_[link.b]]++] = {link.a, row_[link.a], link.weight};
  }
  // Links of the same two nodes become one.
  std::size_t out = 0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const std::size_t first = begin_[k], last = begin_[k + 1];
    std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(first),
              entries_.begin() + static_cast<std::ptrdiff_t>(last),
              [](const Entry& a, const Entry& b) { return a.column < b.column; });
    begin_[k] = out;
    for (std::size_t e = first; e < last; ++e) {
      diagonal_[k] += entries_[e].weight;
      if (out > begin_[k] && entries_[out - 1].column == entries_[e].column)
        entries_[out - 1].weight += entries_[e].weight;
      else
        entries_[out++] = entries_[e];
    }
  }
  begin_.back() = out;
  entries_.resize(out);
}

void Spread::multiply(std::span<const Vec3> x, std::vector<Vec3>& out) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    Vec3 sum = diagonal_[k] * x[k];
    for (std::size_t e = begin_[k]; e < begin_[k + 1]; ++e)
      if (const std::int32_t row = entries_[e].row; row >= 0) sum -= entries_[e].weight * x[row];
    out[k] = sum;
  }
}

std::vector<Vec3> Spread::solve(std::span<const NodeMotion> motions, std::vector<Vec3> b,
                                std::vector<Vec3> x, Accuracy accuracy, const Run& run) const {
  const auto free = [&](std::size_t k, const Vec3& v) { return motions[nodes_[k]].freedom(v); };
  std::vector<Vec3> scaled(nodes_.size());
  std::vector<Vec3> image(nodes_.size());
  const auto scale = [&] {
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      scaled[k] = diagonal_[k] > 0 ? b[k] / diagonal_[k] : Vec3{};
  };
  for (std::size_t k = 0; k < nodes_.size(); ++k) b[k] = free(k, b[k]);
  scale();
  double now = product(b, scaled);
  double enough = kSolver.tolerance * kSolver.tolerance * now;
  if (std::ranges::any_of(x, [](const Vec3& v) { return v != Vec3{}; })) {
    multiply(x, image);
    for (std::size_t k = 0; k < nodes_.size(); ++k) b[k] -= free(k, image[k]);
    scale();
    now = product(b, scaled);
  }
  if (accuracy == Accuracy::Rough) enough = std::max(enough, kSolver.rough * kSolver.rough * now);
  std::vector<Vec3> direction = scaled;
  for (int i = 0; i < kSolver.iterations && now > enough; ++i) {
    run.poll();
    multiply(direction, image);
    for (std::size_t k = 0; k < nodes_.size(); ++k) image[k] = free(k, image[k]);
    const double curvature = product(direction, image);
    if (!(curvature > 0)) break;  // no link resists a motion in this direction
    const double step = now / curvature;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      x[k] += step * direction[k];
      b[k] -= step * image[k];
    }
    scale();
    const double next = product(b, scaled);
    const double keep = next / now;
    for (std::size_t k = 0; k < nodes_.size(); ++k) direction[k] = scaled[k] + keep * direction[k];
    now = next;
  }
  return x;
}

void Spread::forward(std::span<const NodeMotion> motions, std::vector<Vec3>& u, const Run& run,
                     Accuracy accuracy) const {
  if (nodes_.empty()) return;
  std::vector<Vec3> guess(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    Vec3& now = u[nodes_[k]];
    const NodeMotion& motion = motions[nodes_[k]];
    guess[k] = motion.freedom(now - motion.required);
    now = motion.required;
  }
  std::vector<Vec3> pull(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    Vec3 sum;
    for (std::size_t e = begin_[k]; e < begin_[k + 1]; ++e)
      sum += entries_[e].weight * (u[entries_[e].column] - u[nodes_[k]]);
    pull[k] = sum;
  }
  const std::vector<Vec3> x = solve(motions, std::move(pull), std::move(guess), accuracy, run);
  for (std::size_t k = 0; k < nodes_.size(); ++k) u[nodes_[k]] += x[k];
}

void Spread::reverse(std::span<const NodeMotion> motions, std::vector<Vec3>& seed,
                     const Run& run) const {
  if (nodes_.empty()) return;
  std::vector<Vec3> own(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) own[k] = seed[nodes_[k]];
  const std::vector<Vec3> x =
      solve(motions, std::move(own), std::vector<Vec3>(nodes_.size()), Accuracy::Full, run);
  std::vector<Vec3> image(nodes_.size());
  multiply(x, image);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    seed[nodes_[k]] -= image[k];
    for (std::size_t e = begin_[k]; e < begin_[k + 1]; ++e)
      if (entries_[e].row < 0) seed[entries_[e].column] += entries_[e].weight * x[k];
  }
}

}  // namespace remeshd
