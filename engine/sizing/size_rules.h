#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/sizing/size_field.h"
#include "engine/sizing/sizing.h"

namespace remeshd {

/// The size field that a model's boundary and the rules make of a base size: round faces and
/// circular edges of radius r ask for edges of 2 pi r / `edges_per_circle`.
SizeField size_field(const BoundaryModel& boundary, const Sizing& sizing, double base);

}  // namespace remeshd
