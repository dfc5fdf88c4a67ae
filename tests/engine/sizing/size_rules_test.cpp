#include "engine/sizing/size_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

BoundaryModel plate_with_hole() {
  return build_cells(evaluate(test::model_of({test::block("b", 60, 60, 3),
                                              test::placed(test::cylinder("hole", 2, 10), 0, 0, -1,
                                                           Nature::Subtractive)})),
                     kRun)
      .boundary;
}

TEST(SizeRules, CirclesAskForTheirEdgesAndWallsForTheirLayers) {
  const BoundaryModel boundary = plate_with_hole();
  const SizeField field = SizeRules(boundary, {.even = false}, 8, kRun).field(8, 1);
  EXPECT_NEAR(field({2, 0, 1}), 6.28 * 2 / 12, 0.2);
  EXPECT_NEAR(field({25, 25, 0}), 3, 1e-9);
  const SizeField two = SizeRules(boundary, {.even = false, .layers = 2}, 8, kRun).field(8, 1);
  EXPECT_NEAR(two({25, 25, 0}), 3 / edges_asked_across({.even = false, .layers = 2}), 1e-9);
  const SizeField none = SizeRules(boundary, {.even = false, .layers = 0}, 8, kRun).field(8, 1);
  EXPECT_NEAR(none({29, 29, 0}), 8, 1e-9);
}

TEST(SizeRules, AsManyEdgesAsLayersFitAcrossAWall) {
  // Between the sides the field grows: for three layers there was room for 2.5 edges.
  const BoundaryModel plate =
      build_cells(evaluate(test::model_of({test::block("b", 60, 60, 3)})), kRun).boundary;
  for (const std::uint32_t layers : {1U, 2U, 3U, 4U, 6U, 10U, 16U}) {
    const SizeField field =
        SizeRules(plate, {.even = false, .layers = layers, .min_size = 0.01}, 8, kRun).field(8, 1);
    double edges = 0;
    constexpr int kSteps = 1000;
    for (int k = 0; k < kSteps; ++k) edges += 3.0 / kSteps / field({5, 5, 3 * (k + 0.5) / kSteps});
    EXPECT_GT(edges, 0.85 * layers) << layers;
    EXPECT_LT(edges, 1.15 * layers) << layers;
  }
}

BoundaryModel revolved(std::vector<ProfileEntry> profile) {
  return build_cells(evaluate(test::model_of({test::feature(
                         "turned", "revolution", std::move(profile), {{"angle", 360.0}})})),
                     kRun)
      .boundary;
}

TEST(SizeRules, AConeNextToFlatAsksForNoMoreThanAPlane) {
  // A flange 30 wide that rises by .1: each point of it asked for a thousandth of its radius.
  using test::point;
  const BoundaryModel flange =
      revolved({point(8.0, 0.0), point(30.0, 0.0), point(30.0, 6.0), point(8.0, 6.1)});
  const SizeRules rules(flange, {.even = false, .layers = 0}, 4, kRun);
  const SizeField field = rules.field(4, 1);
  for (const double r : {12.0, 20.0, 29.0}) EXPECT_EQ(field({r, 0, 6}), 4) << r;
  EXPECT_TRUE(rules.unresolved(4, 1).empty());
}

TEST(SizeRules, AFaceThatBendsRoundItsAxisAsksForEdgesOnThoseCircles) {
  using test::arc;
  using test::point;
  // Arcs of radius 226 and 60 from end to end: the faces bend as circles of radius 12 and 2.
  const BoundaryModel barrel =
      revolved({point(0.0, 0.0), point(10.0, 0.0), arc(10.0, 60.0, 12.0, 30.0), point(0.0, 60.0)});
  const BoundaryModel waist =
      revolved({point(0.0, 0.0), point(10.0, 0.0), arc(10.0, 60.0, 2.0, 30.0), point(0.0, 60.0)});
  const double edge = 6.2832 / 12 / 1.2;
  const SizeRules of_barrel(barrel, {.even = false, .layers = 0}, 9, kRun);
  const SizeRules of_waist(waist, {.even = false, .layers = 0}, 9, kRun);
  EXPECT_NEAR(of_barrel.field(9, 1)({12, 0, 30}), 12 * edge, 0.5);
  EXPECT_NEAR(of_waist.field(9, 1)({2, 0, 30}), 2 * edge, 0.1);
  EXPECT_TRUE(of_barrel.unresolved(9, 1).empty());
  EXPECT_EQ(of_waist.unresolved(20, 1).size(), 1U) << "the waist";
  // At its tips a lemon bends as sharply as one likes, which is no detail.
  const BoundaryModel lemon = revolved({point(0.0, 0.0), arc(0.0, 60.0, 12.0, 30.0)});
  const SizeRules of_lemon(lemon, {.even = false, .layers = 0}, 9, kRun);
  EXPECT_NEAR(of_lemon.field(9, 1)({12, 0, 30}), 12 * edge, 0.5);
  EXPECT_LT(of_lemon.field(9, 1)({0.5, 0, 0.6}), 2);
  EXPECT_TRUE(of_lemon.unresolved(9, 1).empty());
  // And between the tips of an apple, 4.6 from its middle, there is no face.
  const BoundaryModel apple =
      revolved({point(0.0, -std::sqrt(21.0)), arc(0.0, std::sqrt(21.0), 7.0, 0.0)});
  const SizeRules of_apple(apple, {.even = false, .layers = 0}, 2, kRun);
  EXPECT_LT(of_apple.field(2, 1)({0, 0, 4.5}), 0.4);
  EXPECT_NEAR(of_apple.field(2, 1)({0, 0, 0}), 0.2 + 0.3 * 4.58, 0.1);
}

TEST(SizeRules, OfAFilletOnTheOutsideTheInnerCirclesDoNotCount) {
  // The outer half of a ring whose inner half would be a hole of radius .1.
  using test::arc;
  using test::point;
  const BoundaryModel half =
      revolved({point(0.0, 0.0), point(5.1, 0.0), arc(5.1, 10.0, 10.1, 5.0), point(0.0, 10.0)});
  const SizeField field = SizeRules(half, {.even = false, .layers = 0}, 9, kRun).field(9, 1);
  EXPECT_GT(field({0.1, 0, 5}), 2);
}

TEST(SizeRules, ShortEdgesAskForNoLongerOnesAndTheShortestForNothing) {
  // A wedge whose back is so wide: the faces beside it meet, so that nothing else is thin there.
  const auto wedge = [](double back) {
    return build_cells(evaluate(test::model_of(
                           {test::feature("wedge", "prism",
                                          {test::point(0.0, 0.0), test::point(30.0, -back / 2),
                                           test::point(30.0, back / 2)},
                                          {{"height", 40.0}})})),
                       kRun)
        .boundary;
  };
  const SizeField field = SizeRules(wedge(2), {.even = false}, 8, kRun).field(8, 1);
  EXPECT_NEAR(field({30, 0, 40}), 2, 1e-9);
  EXPECT_NEAR(field({26, 0, 40}), 2 + 0.3 * 4, 1e-9) << "longer and longer beside";
  const SizeField none = SizeRules(wedge(2), {.even = false, .layers = 0}, 8, kRun).field(8, 1);
  EXPECT_EQ(none({30, 0, 40}), 8);
  const SizeField least = SizeRules(wedge(0.15), {.even = false}, 8, kRun).field(8, 1);
  EXPECT_NEAR(least({30, 0, 40}), 0.8, 1e-9);
  const SizeField shortest = SizeRules(wedge(0.07), {.even = false}, 8, kRun).field(8, 1);
  EXPECT_EQ(shortest({30, 0, 40}), 8) << "less than a tenth of the least size";
}

TEST(SizeRules, AreWeakenedAllAlike) {
  const SizeRules rules(plate_with_hole(), {.even = false}, 8, kRun);
  const SizeField strong = rules.field(8, 1), weak = rules.field(8, 1.5);
  EXPECT_NEAR(weak({2, 0, 1}), 1.5 * strong({2, 0, 1}), 1e-9);
  EXPECT_NEAR(weak({25, 25, 0}), 1.5 * strong({25, 25, 0}), 1e-9);
}

TEST(SizeRules, NameTheFacesThatTheLeastSizeLeavesUnresolved) {
  const BoundaryModel boundary = plate_with_hole();
  Sizing sizing{.even = false, .layers = 0, .min_size = 1.5};
  const auto faces = SizeRules(boundary, sizing, 8, kRun).unresolved(8, 1);
  ASSERT_FALSE(faces.empty());
  EXPECT_EQ(faces.size(), 1U) << "the hole's wall, not the plate that its rims are on";
  EXPECT_EQ(boundary.faces[faces.front().face].names.front().face, "wall");
  EXPECT_NEAR(std::hypot(faces.front().at.x, faces.front().at.y), 2, 1e-6);
  sizing.min_size = 0.5;
  EXPECT_TRUE(SizeRules(boundary, sizing, 8, kRun).unresolved(8, 1).empty());
}

TEST(SizeRules, AFilmGetsNoEdgesForItsThicknessAndIsUnresolved) {
  // The least size of a base of 8 is .8; a quarter of that is .2.
  for (const double thickness : {0.15, 0.25}) {
    const BoundaryModel plate =
        build_cells(evaluate(test::model_of({test::block("b", 60, 60, thickness)})), kRun).boundary;
    const SizeRules rules(plate, {.even = false}, 8, kRun);
    EXPECT_NEAR(rules.field(8, 1)({0, 0, 0}), thickness < 0.2 ? 8 : 0.8, 1e-9) << thickness;
    if (thickness > 0.2) continue;
    std::set<std::string> unresolved;
    for (const auto& asked : rules.unresolved(8, 1))
      unresolved.insert(plate.faces[asked.face].names.front().face);
    EXPECT_TRUE(unresolved.contains("top") && unresolved.contains("bottom"));
  }
}

TEST(SizeRules, BothSidesOfAThinWallTakeNodes) {
  const SizeRules rules(plate_with_hole(), {.even = false, .edges_per_circle = 0}, 8, kRun);
  // A layer of tets has a node to 3^2 on each side, a start one to each 3^3 / sqrt(2).
  double nodes = 0, with_fine_edges = 0;
  for (const ThinSide& side : rules.sides()) {
    nodes += side.nodes(rules.field(8, 1)(side.middle));
    with_fine_edges += side.nodes(0.5);
  }
  EXPECT_NEAR(nodes, 2 * 3600 / 9.0 * (0.82 - 0.5 * 1.41), 20);
  EXPECT_EQ(with_fine_edges, 0);
}

TEST(SizeRules, OfAWallAreAsThinForTheBaseExpectedAsForThatBaseAlone) {
  // They were as thin as the greatest base lets a wall be, and the first edit made it anew.
  const BoundaryModel plate =
      build_cells(evaluate(test::model_of({test::block("b", 30, 20, 0.5)})), kRun).boundary;
  const Vec3 middle{0, 0, 0.25};
  const SizeField alone = SizeRules(plate, {.even = false}, 4, kRun).field(4, 1);
  const SizeField of_a_range = SizeRules(plate, {.even = false}, {16, 4}, kRun).field(4, 1);
  EXPECT_NEAR(alone(middle), 0.5, 0.1);
  EXPECT_EQ(of_a_range(middle), alone(middle));
}

}  // namespace
}  // namespace remeshd
