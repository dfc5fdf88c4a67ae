#pragma once

#include <array>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/selection/selected_faces.h"

namespace remeshd {

/// The part of a face where a condition holds, in triangles, outward oriented, whose corners beside
/// those of the face's own triangulation are on its surface.
///
/// What is longer than a sixteenth of the face is bisected before the condition is asked, at
/// corners, middles of sides and centre; where it holds at some of them only, down to `length`, or
/// to a thousandth of the face if that is more. Of the smallest the centre decides. A part narrower
/// than a sixteenth of the face may be missed.
std::vector<std::array<Vec3, 3>> part_where(const BoundaryFace& face,
                                            const OpenExpression& condition, double length,
                                            const Run& run);

}  // namespace remeshd
