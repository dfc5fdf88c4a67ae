#include "engine/sizing/thin_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
constexpr ThinPlaceLimits kThree{.most = 3, .least = 0.1, .slope = 0.3};

BoundaryModel boundary_of(const ModelSource& source) {
  return build_cells(evaluate(source), kRun).boundary;
}

double area(const std::vector<ThinPlace>& places) {
  double sum = 0;
  for (const ThinPlace& p : places)
    sum += 0.5 * norm(cross(p.triangle[1] - p.triangle[0], p.triangle[2] - p.triangle[0]));
  return sum;
}

double least(const std::vector<ThinPlace>& places) {
  double thickness = HUGE_VAL;
  for (const ThinPlace& p : places) thickness = std::fmin(thickness, p.thickness);
  return thickness;
}

TEST(ThinPlaces, AreBothSidesOfAPlate) {
  const auto places =
      thin_places(boundary_of(test::model_of({test::block("b", 30, 20, 2)})), kThree, kRun);
  EXPECT_EQ(places.size(), 4U);  // two triangles a side
  EXPECT_NEAR(area(places), 2 * 30 * 20, 1e-9);
  for (const ThinPlace& place : places) EXPECT_NEAR(place.thickness, 2, 1e-12);
}

TEST(ThinPlaces, AreNotWhereWallsAreThicker) {
  EXPECT_TRUE(thin_places(boundary_of(test::model_of({test::block("b", 30, 20, 4)})), kThree, kRun)
                  .empty());
}

TEST(ThinPlaces, AreNotInCorners) {
  // The faces of a wedge are as near to each other as can be where they meet.
  const BoundaryModel cone = boundary_of(test::model_of({test::feature(
      "c", "cone", {{"radius_bottom", 10.0}, {"radius_top", 0.0}, {"height", 9.0}})}));
  EXPECT_TRUE(thin_places(cone, kThree, kRun).empty());
}

TEST(ThinPlaces, AreTheSidesOfAGapAndTheWallBeneath) {
  const BoundaryModel boundary = boundary_of(
      test::model_of({test::block("b", 30, 30, 10),
                      test::placed(test::block("slot", 1, 40, 8), 0, 0, 4, Nature::Subtractive)}));
  const auto places = thin_places(boundary, {.most = 3, .least = 0.1, .slope = 10}, kRun);
  EXPECT_NEAR(least(places), 1, 1e-12);
  double in_gap = 0;
  for (const ThinPlace& p : places)
    if (std::ranges::all_of(p.triangle, [](const Vec3& q) { return std::fabs(q.x) < 0.6; }) &&
        std::ranges::any_of(p.triangle, [](const Vec3& q) { return q.z > 4; }))
      in_gap += area({p});
  EXPECT_NEAR(in_gap, 2 * 30 * 6, 1e-6);
}

TEST(ThinPlaces, OfARoundWallAreAsThickAsItIs) {
  const BoundaryModel tube = boundary_of(
      test::model_of({test::cylinder("c", 10, 20), test::placed(test::cylinder("bore", 9.5, 30), 0,
                                                                0, -5, Nature::Subtractive)}));
  const auto places = thin_places(tube, kThree, kRun);
  ASSERT_FALSE(places.empty());
  for (const ThinPlace& place : places) EXPECT_NEAR(place.thickness, 0.5, 0.02);
}

TEST(ThinPlaces, ThatAreThinnerThanTheLeastSaySo) {
  const BoundaryModel plate = boundary_of(test::model_of({test::block("b", 30, 20, 0.5)}));
  for (const auto& [least, thinner] : {std::pair{0.4, false}, std::pair{0.6, true}}) {
    const auto places = thin_places(plate, {.most = 3, .least = least, .slope = 10}, kRun);
    ASSERT_FALSE(places.empty());
    for (const ThinPlace& place : places) EXPECT_EQ(place.thinner, thinner) << least;
  }
}

TEST(ThinPlaces, AreTheSameWithAnyNumberOfThreads) {
  const BoundaryModel boundary = boundary_of(test::case_model("detailed/coldplate"));
  const auto one = thin_places(boundary, kThree, {.threads = 1});
  const auto three = thin_places(boundary, kThree, {.threads = 3});
  ASSERT_FALSE(one.empty());
  EXPECT_TRUE(std::ranges::equal(one, three, [](const ThinPlace& a, const ThinPlace& b) {
    return a.face == b.face && a.triangle == b.triangle && a.thickness == b.thickness;
  }));
}

TEST(ThinPlaces, AreFoundFromTheSmallerSide) {
  // The large faces' triangles have the pin far from their corners and middles.
  const BoundaryModel boundary = boundary_of(test::model_of(
      {test::block("b", 90, 90, 20),
       test::placed(test::cylinder("hole", 1.5, 19), 17, 5, 0.5, Nature::Subtractive)}));
  EXPECT_NEAR(least(thin_places(boundary, kThree, kRun)), 0.5, 1e-9);
}

TEST(ThinPlaces, AreNotWhereThicknessGrowsFasterThanSizesMay) {
  // A ball over a plane: far up its side the size that the foot asks for has grown to less.
  const BoundaryModel boundary =
      boundary_of(test::model_of({test::block("b", 40, 40, 30),
                                  test::placed(test::feature("ball", "sphere", {{"radius", 10.0}}),
                                               0, 0, 11, Nature::Subtractive)}));
  const auto few = thin_places(boundary, kThree, kRun);
  const auto all = thin_places(boundary, {.most = 3, .least = 0.1, .slope = 10}, kRun);
  EXPECT_NEAR(least(few), 1, 0.05);
  EXPECT_LT(area(few), 0.7 * area(all));
}

TEST(ThinPlaces, OfALargeTriangleAreNotBetweenTheThinOnes) {
  // The corners of the top and the middles of its two triangles are over pockets, the rest is not.
  std::vector<FeatureSource> features{test::block("b", 60, 60, 10)};
  int k = 0;
  for (const double at : {10.0, 27.0})
    for (const double x : {-at, at})
      for (const double y : {-at, at})
        features.push_back(test::placed(test::block("p" + std::to_string(k++), 8, 8, 9), x, y, 0,
                                        Nature::Subtractive));
  double on_top = 0;
  for (const ThinPlace& p : thin_places(boundary_of(test::model_of(features)), kThree, kRun))
    if (std::ranges::all_of(p.triangle, [](const Vec3& q) { return q.z > 9.999; }))
      on_top += area({p});
  EXPECT_GT(on_top, 8 * 64);   // over the pockets
  EXPECT_LT(on_top, 8 * 196);  // no further than 3 from them
}

}  // namespace
}  // namespace remeshd
