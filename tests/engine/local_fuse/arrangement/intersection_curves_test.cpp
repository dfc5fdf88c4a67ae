#include "engine/local_fuse/arrangement/intersection_curves.h"

#include <gtest/gtest.h>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::FuseInput;
using test::model_of;
using test::placed;
using test::reason_of;
using test::turned;

/// Why two features have no curves.
std::string no_curves_for(const FeatureSource& a, const FeatureSource& b) {
  const FuseInput in(model_of({a, b}));
  const auto patches = find_patches(in.model, in.membership, in.features);
  return patches ? reason_of(find_intersection_curves(*patches, in.clearance)) : reason_of(patches);
}

const FeatureSource kPlate = block("plate", 20, 20, 2), kPipe = cylinder("pipe", 4, 10);

TEST(IntersectionCurvesTest, PlanesThatNearlyCoincideAreGivenUp) {
  EXPECT_EQ(no_curves_for(kPlate, placed(block("b", 6, 6, 2), 0, 0, 0)), "");
  EXPECT_EQ(no_curves_for(kPlate, placed(block("b", 6, 6, 2), 0, 0, 1e-5)),
            "intersection_curves: two parallel planes are neither clearly the same nor clearly "
            "apart");
  EXPECT_EQ(no_curves_for(kPlate, turned(block("b", 6, 6, 6), {5e-4, 0, 1}, {1, 0, -5e-4})),
            "intersection_curves: two planes meet at a very small angle");
}

TEST(IntersectionCurvesTest, APlaneThatNearlyTouchesACylinderIsGivenUp) {
  const auto with_side_at = [](double y) {
    return no_curves_for(kPipe, placed(block("fin", 10, 2, 3), 5, y - 1, 4));
  };
  EXPECT_EQ(with_side_at(3), "");
  const std::string touches =
      "intersection_curves: a plane touches or nearly touches a cylinder along its side";
  for (const double y : {3.95, 4.0}) EXPECT_EQ(with_side_at(y), touches) << y;
}

TEST(IntersectionCurvesTest, APlaneAskewToACylindersAxisHasToBeSoByMuch) {
  const auto with_slope = [](double slope) {
    return no_curves_for(
        kPipe, placed(turned(block("fin", 10, 2, 3), {slope, 0, 1}, {1, 0, -slope}), 5, 0, 4));
  };
  EXPECT_EQ(with_slope(0.4), "");
  EXPECT_EQ(with_slope(0.05),
            "intersection_curves: a plane meets the axis of a cylinder at a small angle");
  EXPECT_EQ(with_slope(5e-4),
            "intersection_curves: a plane is nearly but not clearly at right angles to the axis of "
            "a cylinder");
}

TEST(IntersectionCurvesTest, CylindersMeetOnlyWhereTheirAxesAreParallel) {
  EXPECT_EQ(no_curves_for(kPipe, turned(cylinder("tee", 2, 10), {1, 0, 0}, {0, 1, 0})),
            "intersection_curves: two cylinders meet or nearly meet whose axes are not parallel");
  EXPECT_EQ(no_curves_for(kPipe, placed(cylinder("b", 2, 6), 4, 0, 2)), "");
  for (const double x : {2.0, 6.0})
    EXPECT_EQ(no_curves_for(kPipe, placed(cylinder("b", 2, 6), x, 0, 2)),
              "intersection_curves: two parallel cylinders touch or nearly touch")
        << x;
}

TEST(IntersectionCurvesTest, AnEdgeThatTouchesACylinderIsGivenUp) {
  // The lowest edge of a tilted block lies 4 to the left of its origin, along y.
  const auto with_edge_at = [](double x) {
    return no_curves_for(
        kPipe, placed(turned(block("b", 10, 2, 10), {0.6, 0, 0.8}, {0.8, 0, -0.6}), x + 4, 0, 0));
  };
  EXPECT_EQ(with_edge_at(3), "");
  for (const double x : {3.99, 4.0})
    EXPECT_EQ(with_edge_at(x),
              "intersection_curves: a curve touches or nearly touches a face of another feature")
        << x;
}

TEST(IntersectionCurvesTest, AnEdgeThatIsNearlyInAPlaneIsGivenUp) {
  // The lowest edge of a ridge, almost level, goes through the top of the plate.
  const auto with_slope = [](double slope) {
    return no_curves_for(
        kPlate, placed(turned(block("ridge", 10, 3, 3), {0, 1, 1}, {1, -slope / 2, slope / 2}), 0,
                       1.5 * std::sqrt(0.5), 2 + 1.5 * std::sqrt(0.5)));
  };
  EXPECT_EQ(with_slope(0.05), "");
  EXPECT_EQ(with_slope(5e-4), "intersection_curves: a line meets a plane at a very small angle");
}

TEST(IntersectionCurvesTest, VeryManyFacesOrCurvesAreGivenUp) {
  const Clearance clearance{1e-10, 1e-4};
  Patches patches;
  patches.patches.resize(251);
  EXPECT_EQ(reason_of(find_intersection_curves(patches, clearance)),
            "intersection_curves: the features have too many faces");
  patches.patches.resize(2);
  for (int k = 0; k <= 1000; ++k)
    patches.edges.push_back({.from = {0, 1.0 * k, 0}, .to = {1, 1.0 * k, 0}});
  EXPECT_EQ(reason_of(find_intersection_curves(patches, clearance)),
            "intersection_curves: there are too many curves");
}

}  // namespace
}  // namespace remeshd
