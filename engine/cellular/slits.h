#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// Whether an edge of the boundary is shorter than `widest` (length), or has a point that is nearer
/// than that to a face that it does not meet: beside a step, a slit or a film that narrow. Edges
/// are looked at in five places.
bool has_slits(const BoundaryModel& boundary, double widest);

}  // namespace remeshd
