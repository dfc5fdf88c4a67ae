#include "engine/boundary/facet_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

TEST(FacesOf, AVertexOfABlockLiesOnThreeFacesAnEdgeOnTwo) {
  const CellularModel cells = build_cells(
      evaluate(
          test::one_feature(test::feature("b", "block", {{"dx", 2.0}, {"dy", 3.0}, {"dz", 4.0}}))),
      kRun);
  const FacesOf faces(cells.boundary);
  ASSERT_EQ(cells.boundary.vertices.size(), 8U);
  for (int v = 0; v < 8; ++v) EXPECT_EQ(faces({Support::Kind::Vertex, v}).size(), 3U);
  for (int e = 0; e < 12; ++e) EXPECT_EQ(faces({Support::Kind::Edge, e}).size(), 2U);
  EXPECT_EQ(faces({Support::Kind::Face, 4}).size(), 1U);
  EXPECT_TRUE(faces({}).empty());
}

TEST(FacesOf, OppositeFacesOfABlockShareNoneWithAVertexOfOne) {
  const CellularModel cells = build_cells(
      evaluate(
          test::one_feature(test::feature("b", "block", {{"dx", 2.0}, {"dy", 3.0}, {"dz", 4.0}}))),
      kRun);
  const FacesOf faces(cells.boundary);
  for (int v = 0; v < 8; ++v) {
    const Support vertex{Support::Kind::Vertex, v};
    int shared = 0;
    for (int f = 0; f < 6; ++f) {
      const std::array<Support, 2> pair{vertex, Support{Support::Kind::Face, f}};
      const int common = faces.common(pair);
      if (common >= 0) {
        EXPECT_EQ(common, f);
        ++shared;
      }
    }
    EXPECT_EQ(shared, 3);
  }
}

TEST(FacesOf, TheApexOfAConeLiesOnItsWall) {
  const CellularModel cells = build_cells(
      evaluate(test::one_feature(test::feature(
          "c", "cone", {{"radius_bottom", 2.0}, {"radius_top", 0.0}, {"height", 4.0}}))),
      kRun);
  ASSERT_EQ(cells.boundary.vertices.size(), 1U);
  const FacesOf faces(cells.boundary);
  const auto at_apex = faces({Support::Kind::Vertex, 0});
  ASSERT_EQ(at_apex.size(), 1U);
  EXPECT_EQ(cells.boundary.faces[at_apex[0]].surface.kind, Surface::Kind::Cone);
}

/// A strip of the small cylinder's wall, 0.73 wide, stands out of the large one's by 0.01.
BoundaryModel strip_on_a_wall() {
  ModelSource model =
      test::one_feature(test::feature("large", "cylinder", {{"radius", 10.0}, {"height", 10.0}}));
  FeatureSource small = test::feature("small", "cylinder", {{"radius", 4.0}, {"height", 6.0}});
  small.placement.origin = {6.01, 0.0, 2.0};
  model.features.push_back(small);
  return build_cells(evaluate(model), kRun).boundary;
}

TEST(FacetFaces, AFacetAcrossAStripBetweenTwoFacesOfNearlyTheSameNormalIsTheStrips) {
  const BoundaryModel boundary = strip_on_a_wall();
  // Two nodes on one of the lines that the strip shares with the large wall, one on the other.
  std::vector<Support> supports;
  std::vector<Vec3> nodes;
  int strip = -1;
  for (std::size_t e = 0; e < boundary.edges.size(); ++e) {
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.curve.kind != Curve::Kind::Line) continue;
    for (const double along : {0.3, 0.6}) {
      supports.push_back({Support::Kind::Edge, static_cast<std::int32_t>(e)});
      nodes.push_back(edge.points.front() + along * (edge.points.back() - edge.points.front()));
    }
    for (const int f : edge.faces)
      if (boundary.faces[f].surface.r1 == 4.0) strip = f;
  }
  ASSERT_EQ(nodes.size(), 4U);
  const FacetFaces faces(boundary, supports);
  EXPECT_EQ(faces.face_of({0, 1, 2}, nodes[0], nodes[1], nodes[2]), strip);
  EXPECT_EQ(faces.face_of({1, 2, 3}, nodes[1], nodes[2], nodes[3]), strip);
}

/// At an angle round the z axis, in degrees.
Vec3 round_axis(double radius, double degrees, double z) {
  const double t = degrees * std::numbers::pi / 180;
  return {radius * std::cos(t), radius * std::sin(t), z};
}

/// Whether a facet lies across a face of this surface.
bool lies_across(const Surface& surface, const std::array<Vec3, 3>& corners) {
  BoundaryModel boundary;
  boundary.faces.emplace_back().surface = surface;
  return FacetFaces(boundary, {}).lies_across(0, corners);
}

TEST(FacetFaces, AFacetWithTheAxisThroughItLiesAcrossAHoleHoweverLongItIs) {
  const Surface hole{.kind = Surface::Kind::Cylinder, .r1 = 1};
  const auto at = [](double degrees, double z) { return round_axis(1, degrees, z); };
  EXPECT_TRUE(lies_across(hole, {at(0, 0), at(120, 0), at(240, 0)}));
  EXPECT_TRUE(lies_across(hole, {at(0, 0), at(170, 0), at(190, 800)}));
  EXPECT_TRUE(lies_across(hole, {at(190, 800), at(170, 0), at(0, 0)})) << "from either side";
  EXPECT_TRUE(lies_across(hole, {at(0, 0), at(180, 0), at(180, 20)})) << "along the axis";
  EXPECT_FALSE(lies_across(hole, {at(0, 0), at(120, 0), at(60, 8)})) << "steep, but on one side";
  EXPECT_FALSE(lies_across(hole, {at(0, 0), at(0, 20), at(170, 0)}));
}

TEST(FacetFaces, AFacetAtTheApexOfAConeIsOnItsWall) {
  const Surface cone{.kind = Surface::Kind::Cone, .r1 = 10, .r2 = -1};
  EXPECT_FALSE(lies_across(cone, {Vec3{0, 0, 10}, round_axis(10, 0, 0), round_axis(10, 120, 0)}));
  EXPECT_TRUE(
      lies_across(cone, {round_axis(9, 0, 1), round_axis(10, 120, 0), round_axis(10, 240, 0)}));
}

TEST(FacetFaces, ATorusHasATubeToBeClosedAndAHole) {
  const Surface torus{.kind = Surface::Kind::Torus, .r1 = 20, .r2 = 5};
  EXPECT_TRUE(lies_across(torus, {Vec3{25, 0, 0}, Vec3{17, 0, 4}, Vec3{17, 3, -4}}));
  EXPECT_FALSE(lies_across(torus, {Vec3{25, 0, 0}, Vec3{24, 0, 3}, Vec3{24, 7, 0}}));
  EXPECT_TRUE(
      lies_across(torus, {round_axis(15, 0, 0), round_axis(15, 120, 0), round_axis(15, 240, 0)}));
}

}  // namespace
}  // namespace remeshd
