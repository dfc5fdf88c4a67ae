#pragma once

#include <vector>

#include "engine/local_fuse/arrangement/sweeps.h"

namespace remeshd {

/// A side of a sweep on a piece of the outlines.
struct ArrangementCover {
  int sweep = -1;
  const SolidFace* face = nullptr;
  bool left = true;  ///< where the sweep lies
  friend bool operator==(const ArrangementCover&, const ArrangementCover&) = default;
};

/// A part of a line, an arc or a circle between two nodes; no other piece meets it but there.
struct ArrangementEdge {
  int a = -1, b = -1;  ///< nodes; the same of a circle
  bool round = false;  ///< then it turns left from a to b
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
/// Gives up where round sides meet others but at their ends, which a kernel is for, or
/// anything comes so near to something else that it is not clear whether they meet, or there are
/// very many.
Tried<PlanarArrangement> arrange(const Sweeps& sweeps, const Membership& membership,
                                 double diagonal);

/// Of the diagonal: what is nearer is the same, and where nothing may lie beyond.
constexpr double kSameOutline = 1e-11, kClearOutline = 1e-5;

}  // namespace remeshd
