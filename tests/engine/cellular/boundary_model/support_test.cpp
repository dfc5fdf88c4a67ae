#include "engine/cellular/boundary_model/support.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/base/random.h"
#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

using Kind = Support::Kind;

BoundaryModel boundary_of_feature(FeatureSource source) {
  return build_cells(evaluate(test::one_feature(std::move(source))), kRun).boundary;
}

BoundaryModel half_disc() {
  return boundary_of_feature(test::feature(
      "a", "prism", {test::point(-2.0, 0.0), test::point(2.0, 0.0), test::arc(-2.0, 0.0, 0.0, 2.0)},
      {{"height", 5.0}}));
}

/// Block with a round hole straight across a round boss: its rims are neither lines nor circles.
BoundaryModel crossed_cylinders() {
  ModelSource source;
  source.name = "test";
  source.features = {test::feature("boss", "cylinder", {{"radius", 5.0}, {"height", 20.0}}),
                     test::feature("hole", "cylinder", {{"radius", 3.0}, {"height", 20.0}})};
  source.features[1].nature = Nature::Subtractive;
  source.features[1].placement.origin = {-10.0, 0.0, 10.0};
  source.features[1].placement.z_axis = {1.0, 0.0, 0.0};
  return build_cells(evaluate(source), kRun).boundary;
}

const BoundaryEdge& edge_of_kind(const BoundaryModel& b, Curve::Kind kind) {
  for (const BoundaryEdge& edge : b.edges)
    if (edge.curve.kind == kind) return edge;
  throw std::runtime_error("no such edge");
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE(distance(a, b), tolerance)
      << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

TEST(SupportTest, NearestPointOfALineStopsAtItsEnds) {
  const BoundaryModel b =
      boundary_of_feature(test::feature("a", "block", {{"dx", 4.0}, {"dy", 4.0}, {"dz", 4.0}}));
  for (const BoundaryEdge& edge : b.edges) {
    const Vec3 p = b.vertices[edge.start].position, q = b.vertices[edge.end].position;
    expect_near(project(b, edge, p + 2 * (p - q)), p, 0);
    expect_near(project(b, edge, q + 2 * (q - p)), q, 0);
    const Vec3 side = any_perpendicular(edge.curve.direction);
    expect_near(project(b, edge, 0.25 * p + 0.75 * q + 3 * side), 0.25 * p + 0.75 * q, 1e-14);
  }
}

TEST(SupportTest, NearestPointOfAnArcStopsAtTheNearerEnd) {
  const BoundaryModel b = half_disc();
  const BoundaryEdge& arc = edge_of_kind(b, Curve::Kind::Circle);
  const double z = arc.points.front().z;
  expect_near(project(b, arc, {0, 7, z + 1}), {0, 2, z}, 1e-14);
  expect_near(project(b, arc, {1, -1, z}), {2, 0, z}, 1e-12);
  expect_near(project(b, arc, {-1, -1, z}), {-2, 0, z}, 1e-12);
}

TEST(SupportTest, NearestPointOfAWholeCircleLiesOppositeOnlyWhenAsked) {
  const BoundaryModel b =
      boundary_of_feature(test::feature("a", "cylinder", {{"radius", 5.0}, {"height", 10.0}}));
  for (const BoundaryEdge& rim : b.edges) {
    EXPECT_EQ(rim.start, -1);
    EXPECT_EQ(rim.end, -1);
    EXPECT_EQ(rim.points.front(), rim.points.back());
    for (int i = 0; i < 100; ++i) {
      const double a = i * 0.0628;
      const Vec3 expected{5 * std::cos(a), 5 * std::sin(a), rim.points[0].z};
      expect_near(project(b, rim, {9 * std::cos(a), 9 * std::sin(a), 4}), expected, 1e-14);
    }
    EXPECT_NEAR(distance(project(b, rim, {0, 0, 3}), {0, 0, rim.points[0].z}), 5, 1e-14)
        << "from the axis any point is as near";
  }
}

TEST(SupportTest, NearestPointOfACurveOfIntersectionLiesOnBothSurfaces) {
  const BoundaryModel b = crossed_cylinders();
  const BoundaryEdge& rim = edge_of_kind(b, Curve::Kind::Other);
  EXPECT_TRUE(rim.closed());
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 on = rim.points[random.below(rim.points.size())];
    const Vec3 p =
        on + Vec3{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    const Vec3 q = project(b, rim, p);
    for (const int f : rim.faces) EXPECT_NEAR(signed_distance(b.faces[f].surface, q), 0, 1e-12);
    EXPECT_LE(distance(p, q), distance(p, on) + 1e-3) << "near the nearest, not just on the curve";
  }
}

TEST(SupportTest, NodesStandWhereTheirSupportIs) {
  const BoundaryModel b = half_disc();
  const Vec3 p{0.3, 0.4, 1};
  EXPECT_EQ(project(b, Support{Kind::Interior, -1}, p), p);
  for (int f = 0; f < static_cast<int>(b.faces.size()); ++f)
    EXPECT_NEAR(signed_distance(b.faces[f].surface, project(b, Support{Kind::Face, f}, p)), 0,
                1e-14);
  for (int v = 0; v < static_cast<int>(b.vertices.size()); ++v)
    EXPECT_EQ(project(b, Support{Kind::Vertex, v}, p), b.vertices[v].position);
}

TEST(SupportTest, IncidenceHoldsBetweenAnEntityAndWhatBoundsIt) {
  const BoundaryModel b =
      boundary_of_feature(test::feature("a", "block", {{"dx", 4.0}, {"dy", 4.0}, {"dz", 4.0}}));
  int face_edge = 0, face_vertex = 0, edge_vertex = 0;
  for (int f = 0; f < 6; ++f) {
    for (int e = 0; e < 12; ++e) {
      const Support face{Kind::Face, f}, edge{Kind::Edge, e};
      EXPECT_EQ(incident(b, face, edge), incident(b, edge, face));
      face_edge += incident(b, face, edge);
    }
    for (int v = 0; v < 8; ++v)
      face_vertex += incident(b, Support{Kind::Vertex, v}, Support{Kind::Face, f});
  }
  for (int e = 0; e < 12; ++e)
    for (int v = 0; v < 8; ++v)
      edge_vertex += incident(b, Support{Kind::Edge, e}, Support{Kind::Vertex, v});
  EXPECT_EQ(face_edge, 24);
  EXPECT_EQ(face_vertex, 24);
  EXPECT_EQ(edge_vertex, 24);
  EXPECT_TRUE(incident(b, Support{Kind::Edge, 3}, Support{Kind::Edge, 3}));
  EXPECT_FALSE(incident(b, Support{Kind::Edge, 3}, Support{Kind::Edge, 4}));
  EXPECT_FALSE(incident(b, Support{Kind::Interior, -1}, Support{Kind::Face, 0}));
}

TEST(SupportTest, TheApexOfAConeIsAVertexOfItsFaceWithoutAnEdge) {
  const BoundaryModel b = boundary_of_feature(
      test::feature("a", "cone", {{"radius_bottom", 3.0}, {"radius_top", 0.0}, {"height", 4.0}}));
  ASSERT_EQ(b.vertices.size(), 1u);
  expect_near(b.vertices[0].position, {0, 0, 4}, 1e-12);
  EXPECT_TRUE(b.vertices[0].edges.empty());
  for (int f = 0; f < 2; ++f)
    EXPECT_EQ(incident(b, Support{Kind::Vertex, 0}, Support{Kind::Face, f}),
              b.faces[f].surface.kind == Surface::Kind::Cone);
}

}  // namespace
}  // namespace remeshd
