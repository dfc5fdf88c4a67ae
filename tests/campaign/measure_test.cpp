#include "tests/campaign/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

Measure measure_of(const ModelSource& source, double spacing = 0.3) {
  const FeatureModel model = evaluate(source);
  return measure(model, build_cells(model, Run{}).boundary, spacing);
}

FeatureSource at(FeatureSource feature, double x, double y, double z) {
  feature.placement.origin = {x, y, z};
  return feature;
}

FeatureSource cut(FeatureSource feature) {
  feature.nature = Nature::Subtractive;
  return feature;
}

ModelSource block(double dx, double dy, double dz) {
  return test::one_feature(test::feature("block", "block", {{"dx", dx}, {"dy", dy}, {"dz", dz}}));
}

FeatureSource cylinder(const std::string& id, double radius, double height) {
  return test::feature(id, "cylinder", {{"radius", radius}, {"height", height}});
}

TEST(Measure, OfABlockIsItsExtents) {
  const Measure m = measure_of(block(10, 5, 1), 0.7);
  EXPECT_DOUBLE_EQ(m.edge, 1);
  EXPECT_NEAR(m.face, 1, 0.1);
  EXPECT_NEAR(m.wall, 1, 1e-9);
  EXPECT_NEAR(m.apart, 1, 1e-9);
  EXPECT_NEAR(m.angle, 90, 1e-9);
  EXPECT_FALSE(m.tangent);
  EXPECT_FALSE(m.coincident);
  EXPECT_TRUE(m.good_natured(0.9));
  EXPECT_FALSE(m.good_natured(1.1));
}

TEST(Measure, FindsTheWallBetweenAHoleAndTheSide) {
  ModelSource model = block(10, 10, 4);
  model.features.push_back(cut(at(cylinder("hole", 2, 4), 2.5, 0, 0)));
  const Measure m = measure_of(model);
  EXPECT_NEAR(m.wall, 0.5, 0.02);
  EXPECT_NEAR(m.apart, 0.5, 0.02);
}

TEST(Measure, FindsTheGapBetweenTwoBosses) {
  ModelSource model = block(10, 10, 4);
  model.features.push_back(at(cylinder("left", 1, 3), -1.2, 0, 4));
  model.features.push_back(at(cylinder("right", 1, 3), 1.2, 0, 4));
  const Measure m = measure_of(model, 0.2);
  EXPECT_NEAR(m.gap, 0.4, 0.02);
  EXPECT_TRUE(m.coincident);  // feet on the block
}

TEST(Measure, TakesAClosedEdgeByItsDiameter) {
  EXPECT_NEAR(measure_of(test::one_feature(cylinder("pin", 0.5, 3))).edge, 1, 1e-9);
}

TEST(Measure, FindsAWedge) {
  const double half = std::tan(10 * std::numbers::pi / 360);
  const Measure m = measure_of(test::one_feature(test::feature(
      "wedge", "prism",
      {test::point(0.0, 0.0), test::point(10.0, -10 * half), test::point(10.0, 10 * half)},
      {{"height", 3.0}})));
  EXPECT_NEAR(m.angle, 10, 1e-6);
  EXPECT_TRUE(m.wedge());
  EXPECT_FALSE(m.tangent);
  EXPECT_FALSE(m.good_natured(1e-3));
}

TEST(Measure, DoesNotTakeTheRightAngleOfAnEdgeForAWall) {
  EXPECT_NEAR(measure_of(block(8, 8, 8)).smallest(), 8, 1);
}

TEST(Measure, FindsACylinderThatTouchesASideFromWithin) {
  ModelSource model = block(10, 10, 4);
  model.features.push_back(at(cylinder("boss", 5, 8), 0, 0, 0));
  EXPECT_TRUE(measure_of(model).tangent);
}

TEST(Measure, FindsABallThatTouchesAFaceFromWithin) {
  ModelSource model = block(10, 10, 4);
  model.features.push_back(at(test::feature("ball", "sphere", {{"radius", 1.0}}), 0, 0, 3));
  EXPECT_TRUE(measure_of(model).tangent);
  std::get<double>(model.features.back().placement.origin[2]) = 2.5;
  EXPECT_FALSE(measure_of(model).tangent);
}

TEST(Measure, TakesTheSmoothSidesOfASlotForNoContact) {
  const Measure m = measure_of(test::one_feature(
      test::feature("slot", "slot", {{"length", 9.0}, {"width", 4.0}, {"height", 3.0}})));
  EXPECT_FALSE(m.tangent);
  EXPECT_TRUE(m.good_natured(1));
}

TEST(Measure, TellsAFilmFromCoincidence) {
  ModelSource model = block(10, 10, 4);
  model.features.push_back(at(cylinder("boss", 2, 3), 0, 0, 4));
  EXPECT_FALSE(measure_of(model).film);
  EXPECT_TRUE(measure_of(model).coincident);
  std::get<double>(model.features.back().placement.origin[2]) = 4 - 1e-7;
  EXPECT_TRUE(measure_of(model).film);
  EXPECT_FALSE(measure_of(model).good_natured(0.1));
}

}  // namespace
}  // namespace remeshd::campaign
