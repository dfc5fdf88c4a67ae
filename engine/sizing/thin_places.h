#pragma once

#include <array>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// A triangle on a face that another face, which does not meet that one, is near to: across a wall,
/// a gap, or a narrow face between them.
struct ThinPlace {
  int face;
  std::array<Vec3, 3> triangle;
  /// Least distance to the other face at its corners and its middle; at least `least`, but of a
  /// film, at most `film`: thinner than that throughout, or beside what is so.
  double thickness;
};

struct ThinPlaceLimits {
  double most;   ///< length: where walls and gaps are thicker there is no place
  double least;  ///< length > 0: thinner ones count as this thick
  double film;   ///< length < `least`
  double slope;  ///< where thickness grows faster than this along a face there need be no place
};

/// The thin places of all faces. Triangles are divided until they are no larger than the greatest
/// thickness looked for, and on until the thickness is nearly even on each, or they are about as
/// small as it; films are not. Where it is even on both halves of one, that is one place, so that a
/// plate's two large triangles are two places.
///
/// Faces that share an edge or a vertex are left out: they are near each other in any corner. By
/// triangulations, so that round walls are off by the heights of their chords.
std::vector<ThinPlace> thin_places(const BoundaryModel& boundary, const ThinPlaceLimits& limits,
                                   const Run& run);

}  // namespace remeshd
