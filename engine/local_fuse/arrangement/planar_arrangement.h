#pragma once

#include <vector>

#include "engine/local_fuse/arrangement/sweeps.h"

namespace remeshd {

/// A side of a sweep's outline that runs along a piece of the arrangement.
struct ArrangementCover {
  int sweep = -1;
  const SolidFace* face = nullptr;
  bool left = true;  ///< the sweep lies on the piece's left
  friend bool operator==(const ArrangementCover&, const ArrangementCover&) = default;
};

/// A piece of the arrangement: a part of a line, an arc or a circle between two nodes. Pieces meet
/// at nodes only.
struct ArrangementEdge {
  int a = -1, b = -1;  ///< nodes; equal for a circle
  bool round = false;  ///< an arc or a circle, which turns left from a to b
  Vec3 centre;
  double radius = 0, angle = 0;
  std::vector<ArrangementCover> covers;  ///< ascending by sweep
  std::vector<int> left, right;          ///< sweeps on that side, at whatever height; ascending
};

/// The arrangement of the outlines of prisms, seen along their common axis.
struct PlanarArrangement {
  std::vector<Vec3> nodes;  ///< z = 0
  std::vector<ArrangementEdge> pieces;
};

/// Splits outlines by each other and merges what coincides.
///
/// Gives up where a round side meets or nearly meets one of another outline, unless both are the
/// same whole circle, or where other sides come so near to each other that it is not clear whether
/// they meet, or there are very many.
Tried<PlanarArrangement> arrange(const Sweeps& sweeps, const Membership& membership,
                                 double diagonal);

/// x the diagonal: what is nearer than the first is the same, what is further than the second is
/// apart; between them it is in doubt.
constexpr double kSameOutline = 1e-11, kClearOutline = 1e-5;

}  // namespace remeshd
