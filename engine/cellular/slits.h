#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// Whether the boundary has a step, a slit or a thin layer narrower than `widest` (a length): some
/// edge is shorter than `widest`, or a point of it is nearer than `widest` to a face that the edge
/// does not meet. Five points of each edge are tested, its ends included.
bool has_slits(const BoundaryModel& boundary, double widest);

}  // namespace remeshd
