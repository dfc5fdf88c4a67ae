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

/// Where faces are as narrow as a step between two faces that look the same way and meet elsewhere:
/// crescents where walls all but coincide, say. Pieces are no longer than the face is wide there,
/// or than `least` if that is more.
///
/// The narrow sides of walls and gaps, between faces that do not meet, are found by `thin_places`.
/// Left out are the ends of a strip, which narrow to nothing, and what widens like a wedge or a
/// cusp: edges as short as these are narrow would only be many.
std::vector<NarrowPlace> narrow_faces(const BoundaryModel& boundary, const NarrowFaceLimits& limits,
                                      const Run& run);

}  // namespace remeshd
