#include "engine/local_fuse/sewing/plane_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;
using test::reason_of;

/// Points of the plane z = 0, and straight edges between two of them.
Brep straight_edges(std::vector<Vec3> points, const std::vector<std::array<int, 2>>& ends) {
  Brep brep;
  brep.points = std::move(points);
  for (const auto& [a, b] : ends) {
    BrepEdge edge;
    edge.kind = BrepEdge::Kind::Line;
    edge.vertices = {a, b};
    edge.points = {brep.points[a], brep.points[b]};
    edge.chain = {a, b};
    brep.edges.push_back(edge);
  }
  return brep;
}

/// The square of points 0 to 3, one unit wide, by edges 0 to 3; edge 4 stands off to the right.
const Brep kSquare =
    straight_edges({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                   {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});

std::string reason_for(const Brep& brep, const std::vector<PlaneEdge>& edges,
                       const Triangles& known = {}) {
  return reason_of(plane_faces(brep, edges, Surface{}, known));
}

TEST(PlaneFaceTest, FourEdgesBoundASquare) {
  const auto faces = plane_faces(kSquare, {{0}, {1}, {2}, {3}}, Surface{}, {{0, 1, 2}});
  ASSERT_EQ(reason_of(faces), "");
  ASSERT_EQ(faces->size(), 1U);
  EXPECT_EQ(faces->front().triangles.size(), 2U);
  EXPECT_EQ(faces->front().edges, (std::vector{0, 1, 2, 3}));
  EXPECT_NEAR(faces->front().area, 1, 1e-15);
}

TEST(PlaneFaceTest, ABorderThatDoesNotCloseOrCrossesItselfHasNoFaces) {
  const std::string reason = "plane_face: the border does not close, or crosses or touches itself";
  EXPECT_EQ(reason_for(kSquare, {{0}, {1}, {2}}), reason);
  const Brep bow = straight_edges({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                                  {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  EXPECT_EQ(reason_for(bow, {{0}, {1}, {2}, {3}}), reason);
}

TEST(PlaneFaceTest, TwoEdgesOnOnePolylineHaveNoFaces) {
  EXPECT_EQ(reason_for(kSquare, {{0}, {1}, {2}, {3}, {0}}),
            "plane_face: two edges share a segment of their polylines");
}

TEST(PlaneFaceTest, KnownTrianglesHaveToFitTheBorder) {
  EXPECT_EQ(reason_for(kSquare, {{0}, {1}, {2}, {3}}, {{0, 1, 2}, {0, 1, 3}}),
            "plane_face: two triangles lie on the same side of a segment");
  EXPECT_EQ(reason_for(kSquare, {{0}, {1}, {2}, {3}}, {{0, 1, 2}, {2, 1, 4}}),
            "plane_face: known triangles lie on both sides of an edge of the border");
}

TEST(PlaneFaceTest, AnEdgeInsideHasTheRegionOnBothSides) {
  EXPECT_EQ(reason_for(kSquare, {{0}, {1}, {2}, {3}, {4, 2}}),
            "plane_face: an edge has triangles on fewer or more sides than the region");
}

TEST(PlaneFaceTest, TrianglesThatMissMuchOfTheAreaAreGivenUp) {
  // A circle that a polyline of three chords stands for.
  Brep brep;
  BrepEdge circle;
  circle.kind = BrepEdge::Kind::Circle;
  circle.vertices = {0, 0};
  circle.axis = {0, 0, 1};
  circle.radius = 1;
  circle.length = 2 * std::numbers::pi;
  circle.chain = {0, 1, 2, 0};
  for (const double t : {0.0, 2.0, 4.0}) brep.points.push_back({std::cos(t), std::sin(t), 0});
  brep.edges.push_back(circle);
  EXPECT_EQ(reason_for(brep, {{0}}),
            "plane_face: the triangles do not have the area that the edges enclose");
}

}  // namespace
}  // namespace remeshd
