#include "engine/sizing/size_rules.h"

#include <gtest/gtest.h>

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
  EXPECT_NEAR(two({25, 25, 0}), 1.5, 1e-9);
  const SizeField none = SizeRules(boundary, {.even = false, .layers = 0}, 8, kRun).field(8, 1);
  EXPECT_NEAR(none({29, 29, 0}), 8, 1e-9);
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
  const SizeField shortest = SizeRules(wedge(0.15), {.even = false}, 8, kRun).field(8, 1);
  EXPECT_EQ(shortest({30, 0, 40}), 8) << "less than a quarter of the least size";
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
  for (const int f : faces)
    EXPECT_TRUE(boundary.faces[f].surface.kind == Surface::Kind::Cylinder ||
                boundary.faces[f].names.front().face == "top" ||
                boundary.faces[f].names.front().face == "bottom");
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
    if (thickness < 0.2) {
      EXPECT_EQ(rules.unresolved(8, 1).size(), 2U) << "both sides";
    }
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
  EXPECT_NEAR(nodes, 2 * 3600 / 9.0 * (0.92 - 0.5 * 1.41), 20);
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
