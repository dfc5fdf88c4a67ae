#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// Gives an edge the direction and, where it has no vertex, the start that its geometry alone
/// determines, and fills in its curve: from the lower vertex to the higher; a loop turns
/// counter-clockwise about an axis whose first component that is not 0 is positive, or, on other
/// curves, leaves along the smaller of its two neighbours of the start. Circles are sampled anew.
void make_canonical(BoundaryEdge& edge);

/// Moves vertices and the points of other curves onto the exact surfaces of their faces, which the
/// CAD kernel meets to its tolerance only. What is exact already keeps its bits.
void refine(BoundaryModel& model, double tolerance);

/// The point nearest to p that lies on both surfaces, by Newton's method from p; p itself moved
/// onto the first surface where they do not cross.
Vec3 onto_both(const Surface& a, const Surface& b, const Vec3& p);

}  // namespace remeshd
