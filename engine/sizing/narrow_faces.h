#pragma once

#include <array>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// A piece of an edge of a face that another edge of it runs along.
struct NarrowPlace {
  int face;
  std::array<Vec3, 2> piece;
  double width;  ///< of the face, from the middle of the piece
};

struct NarrowFaceLimits {
  double most;   ///< length: where faces are wider there is no place
  double least;  ///< length > 0: pieces are not made shorter than half of this
  double film;   ///< length: where faces are narrower there is no place
};

/// Finds where faces are narrow strips, as the riser of a low step is: the faces beyond its two
/// long edges have normals to the same side, and share an edge or a vertex with each other. An
/// example is the crescent between two walls that almost coincide. A piece is no longer than the
/// strip is wide there, or than `least` if that is more.
///
/// The narrow sides of walls and gaps, between faces that do not meet, are found by `thin_places`.
/// The ends of a strip, which narrow to nothing, and strips that widen like a wedge or a cusp are
/// left out: edges as short as their width would be many and would help nothing.
std::vector<NarrowPlace> narrow_faces(const BoundaryModel& boundary, const NarrowFaceLimits& limits,
                                      const Run& run);

}  // namespace remeshd
