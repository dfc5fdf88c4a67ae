#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/selection/selected_faces.h"

namespace remeshd {

/// Tests a point of a face: f(point, outward unit normal of the face there).
using FaceTest = std::function<bool(const Vec3&, const Vec3&)>;

/// The part of a face in a box where a test holds, as outward oriented triangles. Corners that are
/// not of the face's own triangulation lie on its surface; points tested may be a chord's height
/// off.
///
/// Triangles that meet the box and are longer than 1/16 of its diagonal are bisected. A triangle is
/// then tested at its corners, midpoints of sides and centroid; where the test holds at some of
/// them only, bisection goes on down to `length`, or to 1/1000 of the diagonal if that is more, and
/// there the centroid decides. A part narrower than 1/16 of the diagonal may be missed.
std::vector<std::array<Vec3, 3>> part_within(const Box& box, const BoundaryFace& face,
                                             const FaceTest& holds, double length, const Run& run);
/// The same of a condition, in the box of the face.
std::vector<std::array<Vec3, 3>> part_where(const BoundaryFace& face,
                                            const OpenExpression& condition, double length,
                                            const Run& run);

/// What a condition tells of a place.
struct Held {
  bool holds = false;
  double margin = 0;  ///< as ConditionTest::margin
};
/// Tests a condition at a point of a face: f(point, outward unit normal of the face there).
using PlaceTest = std::function<Held(const Vec3&, const Vec3&)>;

/// Area of the part of a face where a condition holds: its share of the area of bisected triangles,
/// which are cut straight where the condition changes, times the face's exact area.
///
/// A triangle is bisected again if, by its margins, the border of the part may run through it and
/// the margins do not change linearly over it. So a part is found however narrow it is, and the
/// relative error is of the order of 1e-4 where the border is curved. Where margins are not known,
/// a part narrower than 1/16 of the diagonal of the face's box may be missed.
double area_where(const BoundaryFace& face, const PlaceTest& holds, const Run& run);

}  // namespace remeshd
