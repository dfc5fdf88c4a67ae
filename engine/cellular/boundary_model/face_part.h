#pragma once

#include <array>
#include <functional>
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

/// Whether a condition holds at a point of a face with that outward normal.
using PlaceTest = std::function<bool(const Vec3&, const Vec3&)>;

/// Area of the part of a face where a condition holds: of triangles on its surface, cut where the
/// condition changes along their sides, as a share of all of them, times the exact area. Off by the
/// square of 1/256 of the face where the part's border is curved. A part narrower than a sixteenth
/// of the face may be missed.
double area_where(const BoundaryFace& face, const PlaceTest& holds, const Run& run);

}  // namespace remeshd
