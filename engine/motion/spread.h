#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/motion/node_motion.h"

namespace remeshd {

/// Two nodes that would move alike, and how much.
struct MotionLink {
  std::int32_t a, b;
  double weight;
};

/// Gives some nodes of a mesh the motions u that differ least from their neighbours':
///
///     sum of weight |u_a - u_b|^2 over all links  ->  least,
///
/// where each of these nodes may move as its NodeMotion says and all others move as they do. With
/// the weights of linear finite elements that is the discrete harmonic extension, which reproduces
/// linear motions.
class Spread {
 public:
  /// `nodes`: those that it moves; `links`: any; those at none of them count for nothing. Links of
  /// the same two nodes add up. `all`: number of nodes of the mesh.
  Spread(std::span<const std::int32_t> nodes, std::span<const MotionLink> links, std::size_t all);

  [[nodiscard]] std::span<const std::int32_t> nodes() const { return nodes_; }

  /// Of u: all that double precision gives, or three digits more than it has before.
  enum class Accuracy : std::uint8_t { Full, Rough };

  /// Sets u at its nodes. `motions`, `u`: by node of the mesh. What u is before does not matter but
  /// for the time: the nearer to what it becomes, the less.
  void forward(std::span<const NodeMotion> motions, std::vector<Vec3>& u, const Run& run,
               Accuracy accuracy = Accuracy::Full) const;

  /// The transpose. From d J / d u at all nodes to d J / d u at the others, with what reaches them
  /// through these nodes, and d J / d required at these.
  void reverse(std::span<const NodeMotion> motions, std::vector<Vec3>& seed, const Run& run) const;

 private:
  struct Entry {
    std::int32_t column;  ///< node of the mesh
    std::int32_t row;     ///< of that node; -1: it is not of these
    double weight;
  };

  /// Row by row, diagonal x - sum of weight x at its neighbours; x is given for these nodes alone.
  void multiply(std::span<const Vec3> x, std::vector<Vec3>& out) const;
  /// Solves P L P x = P b for x = P x, by conjugate gradients from a guess at x; P: what of each
  /// node is free. Ends where the residual is next to nothing beside that of x = 0, or a thousandth
  /// of what it is at the guess.
  [[nodiscard]] std::vector<Vec3> solve(std::span<const NodeMotion> motions, std::vector<Vec3> b,
                                        std::vector<Vec3> x, Accuracy accuracy,
                                        const Run& run) const;

  std::vector<std::int32_t> nodes_;
  std::vector<std::int32_t> row_;  ///< by node of the mesh; -1: not of these
  std::vector<std::size_t> begin_;
  std::vector<Entry> entries_;
  std::vector<double> diagonal_;
};

}  // namespace remeshd
