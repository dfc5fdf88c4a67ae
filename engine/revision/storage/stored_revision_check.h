#pragma once

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Checks every index of the parts of a boundary, and that its numbers are finite: what joins the
/// parts may rely on that.
///
/// Throws Error(Internal).
void check_parts(const BoundaryParts& parts, const FeatureModel& model);

/// Checks every index, count and coordinate of a revision that was read: what uses it may rely on
/// them.
///
/// Pre: its cells, Delaunay state and output are filled in.
/// Throws Error(Internal), naming the array at fault.
void check_indices(const Revision& revision);

}  // namespace remeshd
