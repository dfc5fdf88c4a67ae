#pragma once

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Looks at every index of the parts of a boundary, and whether its numbers are some: what joins
/// them may rely on that.
///
/// Throws Error(Internal).
void check_parts(const BoundaryParts& parts, const FeatureModel& model);

/// Looks at every index, count and coordinate of a revision that was read: what uses it may rely on
/// them.
///
/// Pre: its cells, Delaunay state and delivery are filled in.
/// Throws Error(Internal), naming the array at fault.
void check_indices(const Revision& revision);

}  // namespace remeshd
