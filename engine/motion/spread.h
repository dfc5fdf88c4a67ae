#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/motion/node_motion.h"

namespace remeshd {

/// Two nodes that tend to move alike, with the weight of that.
struct MotionLink {
  std::int32_t a, b;
  double weight;
};

/// Gives some nodes of a mesh the motions u that differ least from their neighbours':
///
///     sum of weight |u_a - u_b|^2 over all links  ->  least,
///
/// where each of these nodes may move as its NodeMotion says, and u of all others is given. With
/// the weights of linear finite elements that is the discrete harmonic extension, which reproduces
/// linear motions.
class Spread {
 public:
  /// `nodes`: those that it moves; `links`: those at none of these nodes do not count, those of the
  /// same two nodes add up; `all`: number of nodes of the mesh.
  Spread(std::span<const std::int32_t> nodes, std::span<const MotionLink> links, std::size_t all);

  [[nodiscard]] std::span<const std::int32_t> nodes() const { return nodes_; }

  /// How exactly u is solved for: as double precision allows, or to three digits more than the
  /// first guess has.
  enum class Accuracy : std::uint8_t { Full, Rough };

  /// Sets u at its nodes from u at all others. `motions`, `u`: by node of the mesh. What u is at
  /// its nodes before is the first guess: the nearer it is, the less time this takes.
  void forward(std::span<const NodeMotion> motions, std::vector<Vec3>& u, const Run& run,
               Accuracy accuracy = Accuracy::Full) const;

  /// The transpose of `forward`. `seed`, by node of the mesh, is d J / d u on entry. On return it
  /// is d J / d required at `nodes()`, and at all other nodes the total d J / d u, with the part
  /// that reaches J through `nodes()`.
  void reverse(std::span<const NodeMotion> motions, std::vector<Vec3>& seed, const Run& run) const;

 private:
  struct Entry {
    std::int32_t column;  ///< node of the mesh
    std::int32_t row;     ///< of that node; -1: it is none of `nodes_`
    double weight;
  };

  /// The product L x, for x at `nodes_` alone: diagonal * x - sum of weight * x of neighbours, by
  /// row.
  void multiply(std::span<const Vec3> x, std::vector<Vec3>& out) const;
  /// Solves P L P x = P b for x = P x, by conjugate gradients from a guess at x; P takes the free
  /// part of each node's motion. Ends where the residual is 1e-12 of that of x = 0 or, if `Rough`,
  /// a thousandth of that of the guess.
  [[nodiscard]] std::vector<Vec3> solve(std::span<const NodeMotion> motions, std::vector<Vec3> b,
                                        std::vector<Vec3> x, Accuracy accuracy,
                                        const Run& run) const;

  std::vector<std::int32_t> nodes_;
  std::vector<std::int32_t> row_;  ///< by node of the mesh; -1: none of `nodes_`
  std::vector<std::size_t> begin_;
  std::vector<Entry> entries_;
  std::vector<double> diagonal_;
};

}  // namespace remeshd
