#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// Gives an edge the direction that its geometry alone determines, and fills in its curve. An open
/// edge runs from the lower vertex to the higher. A full circle turns counter-clockwise about an
/// axis whose first component that is not 0 is positive; another closed edge leaves its start
/// towards the smaller (`lies_before`) of the two points next to it. Points on circles are sampled
/// anew; a full circle without a vertex starts at a place that its axis determines.
void make_canonical(BoundaryEdge& edge);

/// Moves vertices and the points of curves of Kind::Other onto the exact surfaces of their faces,
/// which the CAD kernel meets to its tolerance only. A vertex that lies on its surfaces to within
/// 1e-6 x `tolerance` keeps its bits.
void refine(BoundaryModel& model, double tolerance);

/// A point near p that lies on both surfaces, by Newton's method from p; where the surfaces are
/// tangent, a point of the first alone.
Vec3 onto_both(const Surface& a, const Surface& b, const Vec3& p);

}  // namespace remeshd
