#pragma once

#include <array>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// A triangle on a face that is near to another face with which that one shares no edge or vertex:
/// across a wall, a gap, or a narrow face between them.
struct ThinPlace {
  int face;
  std::array<Vec3, 3> triangle;
  /// Least distance to such faces at its corners and its middle, but no less than
  /// `ThinPlaceLimits::least`. On a film it is less than `ThinPlaceLimits::film`: where the
  /// distance is less than that at all of these points, or where the place is beside a film.
  double thickness;
  bool thinner;  ///< whether the distance is less than `ThinPlaceLimits::least` somewhere on it
};

struct ThinPlaceLimits {
  double most;   ///< length: where walls and gaps are thicker there is no place
  double least;  ///< length > 0: thinner ones count as this thick
  double film;   ///< length < `least`: a thinner place is a film
  double slope;  ///< a place may be left out that is thicker than another by this x their distance
};

/// The thin places of all faces. The faces' triangles are bisected until they are no larger than
/// `most`, and further until the thickness is nearly even on each or they are about as small as it;
/// films are not bisected further. Where the thickness is nearly even on both halves of a triangle,
/// that is one place: the two large triangles of a plate's side are two places.
///
/// Faces that share an edge or a vertex do not count as near: they are so in any corner. Distances
/// are those of the triangulations, off by the sagitta of chords on round walls.
std::vector<ThinPlace> thin_places(const BoundaryModel& boundary, const ThinPlaceLimits& limits,
                                   const Run& run);

}  // namespace remeshd
