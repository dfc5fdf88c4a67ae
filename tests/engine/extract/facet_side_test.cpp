#include "engine/extract/facet_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

constexpr double kRadius = 5;

/// On the cylinder of that radius round the z axis.
Vec3 on_wall(double angle, double z) {
  return {kRadius * std::cos(angle), kRadius * std::sin(angle), z};
}

/// The side of the tet of these nodes, each on the face next to it.
BoundarySide side_of(const FeatureModel& model, const std::array<Vec3, 4>& corners) {
  const CellularModel cells = build_cells(model, test::kRun);
  const BoundaryModel& boundary = cells.boundary;
  NodeSet nodes;
  for (const Vec3& p : corners) {
    const auto face = std::ranges::min_element(
        boundary.faces, {}, [&](const BoundaryFace& f) { return face_distance2(f, p); });
    nodes.add_new(p, {Support::Kind::Face, static_cast<int>(face - boundary.faces.begin())});
  }
  return side_by_facets(nodes, boundary, FacesOf(boundary), {0, 1, 2, 3});
}

/// A plate with its upper side at z = 4, and a hole through it.
FeatureModel plate_with_a_hole() {
  return evaluate(test::model_of(
      {test::block("plate", 30, 30, 4),
       test::placed(test::cylinder("hole", kRadius, 10), 0, 0, -5, Nature::Subtractive)}));
}
/// The same with a boss of that radius instead.
FeatureModel plate_with_a_boss() {
  return evaluate(
      test::model_of({test::block("plate", 30, 30, 4), test::cylinder("boss", kRadius, 10)}));
}

TEST(FacetSide, ATetBehindAChordOfAHoleIsInsideThoughItsCentroidIsNot) {
  const FeatureModel model = plate_with_a_hole();
  const std::array<Vec3, 4> corners{
      on_wall(-0.2, 3), on_wall(0.2, 3), on_wall(0, 1), {kRadius + 0.02, 0, 4}};
  EXPECT_FALSE(
      Membership(model).inside(0.25 * (corners[0] + corners[1] + corners[2] + corners[3])));
  EXPECT_EQ(side_of(model, corners), BoundarySide::Inside);
}

TEST(FacetSide, ATetBeforeAChordOfABossIsOutsideThoughItsCentroidIsNot) {
  const FeatureModel model = plate_with_a_boss();
  const std::array<Vec3, 4> corners{
      on_wall(-0.2, 5), on_wall(0.2, 5), on_wall(0, 7), {kRadius + 0.02, 0, 4}};
  EXPECT_TRUE(Membership(model).inside(0.25 * (corners[0] + corners[1] + corners[2] + corners[3])));
  EXPECT_EQ(side_of(model, corners), BoundarySide::Outside);
}

TEST(FacetSide, OfAThickTetIsNotAsked) {
  EXPECT_EQ(side_of(plate_with_a_hole(),
                    {on_wall(-0.2, 3), on_wall(0.2, 3), on_wall(0, 1), {kRadius + 1, 0, 4}}),
            BoundarySide::Unknown);
}

TEST(FacetSide, IsNotToldByAFacetAcrossTheHollow) {
  EXPECT_EQ(side_of(plate_with_a_hole(),
                    {on_wall(-1.2, 3), on_wall(1.2, 3), on_wall(0, 1), {kRadius + 0.02, 0, 4}}),
            BoundarySide::Unknown);
}

TEST(FacetSide, IsNotToldByAFacetAcrossAHoleInTheFace) {
  const FeatureModel model = evaluate(test::model_of(
      {test::block("plate", 30, 30, 4), test::cylinder("boss", kRadius, 10),
       test::placed(test::block("cut", 30, 1.5, 1.5), 0, 0, 6, Nature::Subtractive)}));
  EXPECT_EQ(side_of(model,
                    {on_wall(-0.2, 5.6), on_wall(0.2, 5.6), on_wall(0, 8), {kRadius + 0.02, 0, 4}}),
            BoundarySide::Unknown);
}

TEST(FacetSide, IsNotToldByAFacetWithSomethingBetweenItAndItsFace) {
  // A pin stands out of the hole's wall by .03, its end between the wall and a chord of it.
  const FeatureModel model = evaluate(test::model_of(
      {test::block("plate", 30, 30, 4),
       test::placed(test::cylinder("hole", kRadius, 10), 0, 0, -5, Nature::Subtractive),
       test::placed(test::block("pin", 2, 0.6, 0.6), kRadius + 0.97, 0, 1.7)}));
  EXPECT_EQ(
      side_of(model, {on_wall(-0.2, 3), on_wall(0.2, 3), on_wall(0, 1), {kRadius - 0.03, 0, 1.9}}),
      BoundarySide::Unknown);
}

TEST(FacetSide, IsNotToldByAFacetOnAPlaneThoughTheTetIsFlatAgainstIt) {
  EXPECT_EQ(side_of(plate_with_a_boss(),
                    {Vec3{15, 1, 2}, Vec3{15, -1, 2}, Vec3{15, 0, 3}, Vec3{15, 3, 4}}),
            BoundarySide::Unknown);
}

}  // namespace
}  // namespace remeshd
