#include "engine/sizing/narrow_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/cellular/cellular_model.h"
#include "engine/sizing/size_rules.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
using test::point;
constexpr NarrowFaceLimits kNarrow{.most = 3, .least = 0.1, .film = 0.01};

BoundaryModel on_a_block(std::vector<FeatureSource> features) {
  features.insert(features.begin(), test::block("block", 40, 20, 4));
  return build_cells(evaluate(test::model_of(std::move(features))), kRun).boundary;
}

/// A low cylinder whose wall is `offset` outside of a high one's at most.
BoundaryModel crescent(double offset) {
  return on_a_block({test::placed(test::cylinder("high", 6, 10), 0, 0, 4),
                     test::placed(test::cylinder("low", 6, 5), offset, 0, 4)});
}

std::pair<double, double> widths(const std::vector<NarrowPlace>& places) {
  const auto [least, greatest] = std::ranges::minmax(places, {}, &NarrowPlace::width);
  return {least.width, greatest.width};
}

TEST(NarrowFaces, AreCrescentsButForTheirTips) {
  const auto places = narrow_faces(crescent(0.4), kNarrow, kRun);
  ASSERT_FALSE(places.empty());
  const auto [least, greatest] = widths(places);
  EXPECT_NEAR(greatest, 0.4, 0.01);
  EXPECT_GE(least, 0.2);
  for (const NarrowPlace& place : places)
    for (const Vec3& p : place.piece) {
      EXPECT_EQ(p.z, 9);
      EXPECT_GT(p.x, 2.5);
    }
}

TEST(NarrowFaces, AreNoneThatAreAsNarrowAsAFilm) {
  EXPECT_TRUE(narrow_faces(crescent(0.4), {.most = 3, .least = 0.1, .film = 0.5}, kRun).empty());
}

TEST(NarrowFaces, AreNoCusps) {
  // Walls that touch: the top of the low block ends in points beside the cylinder.
  const BoundaryModel boundary = on_a_block({test::placed(test::block("low", 12, 6, 2), 0, 0, 4),
                                             test::placed(test::cylinder("high", 3, 5), 0, 0, 4)});
  EXPECT_TRUE(narrow_faces(boundary, kNarrow, kRun).empty());
}

TEST(NarrowFaces, AreTheWideHalfOfALedgeThatTapers) {
  // From nothing at x = -20 to 2 at x = 20.
  const BoundaryModel boundary = on_a_block({test::placed(
      test::feature("high", "prism",
                    {point(-20.0, -10.0), point(20.0, -10.0), point(20.0, 8.0), point(-20.0, 10.0)},
                    {{"height", 2.0}}),
      0, 0, 4)});
  const auto places = narrow_faces(boundary, kNarrow, kRun);
  ASSERT_FALSE(places.empty());
  const auto [least, greatest] = widths(places);
  EXPECT_NEAR(greatest, 2, 0.2);
  EXPECT_GE(least, 0.9);
  EXPECT_LT(least, 1.2);
}

TEST(NarrowFaces, AreNoSidesOfWalls) {
  const BoundaryModel boundary = on_a_block({test::placed(
      test::feature("wall", "prism", {point(-15.0, 0.0), point(15.0, 0.0), point(15.0, 1.5)},
                    {{"height", 8.0}}),
      0, 0, 4)});
  EXPECT_TRUE(narrow_faces(boundary, kNarrow, kRun).empty());
}

TEST(NarrowFaces, AreNotWhereAnEdgeGoesOnAsAnother) {
  // Lines that go on as arcs round the top of the boss.
  const BoundaryModel boundary = on_a_block({test::placed(
      test::feature("boss", "slot", {{"length", 12.0}, {"width", 8.0}, {"height", 5.0}}), 0, 0,
      4)});
  EXPECT_TRUE(narrow_faces(boundary, kNarrow, kRun).empty());
}

TEST(NarrowFaces, EndWhereTheirEdgesPart) {
  // A strip .4 wide and 8 long whose far edge then turns away by 22 degrees.
  BoundaryModel boundary;
  boundary.faces.resize(3);
  boundary.faces[0].edges = {0, 1};
  for (const int wall : {1, 2})
    boundary.faces[wall].surface = {Surface::Kind::Plane,
                                    Transform::frame({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {})};
  const auto edge = [](std::vector<Vec3> points, std::vector<int> faces) {
    BoundaryEdge e;
    e.points = std::move(points);
    e.faces = std::move(faces);
    return e;
  };
  boundary.edges = {edge({{0, 0, 0}, {10, 0, 0}}, {0, 1}),
                    edge({{0, 0.4, 0}, {8, 0.4, 0}, {10, 1.2, 0}}, {0, 2}),
                    edge({{0, 0, 5}, {0, 0, 9}}, {1, 2})};  // where the walls meet
  const auto places = narrow_faces(boundary, kNarrow, kRun);
  ASSERT_FALSE(places.empty());
  EXPECT_NEAR(widths(places).first, 0.4, 1e-9);
  for (const NarrowPlace& place : places)
    for (const Vec3& p : place.piece) EXPECT_LT(p.x, 9);
}

TEST(NarrowFaces, AskForEdgesAsShortAsTheyAreWide) {
  const Sizing sizing{.even = false};
  const SizeField wide = SizeRules(crescent(0.8), sizing, 4, kRun).field(4, 1);
  EXPECT_NEAR(wide({6, 0, 9}), 0.8, 0.02);
  // As far as the least size lets them.
  const BoundaryModel low = crescent(0.06);
  const SizeRules rules(low, sizing, 4, kRun);
  EXPECT_NEAR(rules.field(4, 1)({6.03, 0, 9}), 0.4, 0.02);
  EXPECT_FALSE(rules.unresolved(4, 1).empty());
  // Beside a lower step finer tets are as flat.
  EXPECT_GT(SizeRules(crescent(0.03), sizing, 4, kRun).field(4, 1)({6.015, 0, 9}), 1);
  EXPECT_EQ(SizeRules(crescent(0.8), {.even = false, .edges_per_circle = 0, .layers = 0}, 4, kRun)
                .field(4, 1)({6, 0, 9}),
            4);
}

}  // namespace
}  // namespace remeshd
