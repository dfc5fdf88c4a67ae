#pragma once

#include <array>
#include <vector>

#include "engine/local_fuse/arrangement/planar_arrangement.h"

namespace remeshd {

/// The heights where sweeps begin and end, and what lies beside the arrangement's pieces in the
/// slabs between: slab s reaches from height s - 1 to height s; the first and the last are the
/// outside, below and above all.
class Slabs {
 public:
  /// What lies on one side of a piece, in a slab.
  struct Column {
    std::vector<int> owners;  ///< sweeps, ascending
    bool material = false;
  };

  /// Gives up where two heights are not clearly the same or apart, or there are very many.
  static Tried<Slabs> find(const Sweeps& sweeps, const PlanarArrangement& arrangement,
                           const Membership& membership, double diagonal);

  [[nodiscard]] int heights() const { return static_cast<int>(z_.size()); }
  [[nodiscard]] double z(int height) const { return z_[height]; }
  /// Slabs count from 0, below the lowest height, to `heights()`.
  [[nodiscard]] const Column& left(int piece, int slab) const { return at(piece, slab)[0]; }
  [[nodiscard]] const Column& right(int piece, int slab) const { return at(piece, slab)[1]; }
  /// Whether a sweep reaches through a slab.
  [[nodiscard]] bool active(int sweep, int slab) const {
    return low_[sweep] < slab && slab <= high_[sweep];
  }

  /// Whether there is a face between left and right.
  [[nodiscard]] bool wall(int piece, int slab) const {
    return left(piece, slab).owners != right(piece, slab).owners;
  }
  /// Whether there is one, and it bounds material.
  [[nodiscard]] bool boundary(int piece, int slab) const {
    return left(piece, slab).material != right(piece, slab).material;
  }
  /// Whether the owners on both sides of a piece are the same below and above a height.
  [[nodiscard]] bool passes(int piece, int height) const {
    return left(piece, height).owners == left(piece, height + 1).owners &&
           right(piece, height).owners == right(piece, height + 1).owners;
  }

 private:
  [[nodiscard]] const std::array<Column, 2>& at(int piece, int slab) const {
    return columns_[static_cast<std::size_t>(piece) * (z_.size() + 1) + slab];
  }

  std::vector<double> z_;
  std::vector<int> low_, high_;                 ///< by sweep: the heights of its ends, by number
  std::vector<std::array<Column, 2>> columns_;  ///< by piece and slab: left, right
};

}  // namespace remeshd
