#include "engine/remesh/finish/insert_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

using test::kRun;

/// A cylinder of radius 10, its boundary alone.
class Circles : public testing::Test {
 protected:
  std::ptrdiff_t nodes_on(int edge) const {
    return std::ranges::count(nodes_.supports, Support{Support::Kind::Edge, edge});
  }
  void recover(bool make_room = false) {
    Box bounds;
    bounds.add(boundary_.bounds.lo);
    bounds.add(boundary_.bounds.hi);
    DelaunayMesh mesh(bounds);
    insert_in_segments(nodes_, mesh, 0, boundary_, {.sizes = 20, .make_room = make_room}, kRun);
  }

  const BoundaryModel boundary_ = test::make_cylinder(10, 8, 12, 1).boundary;
  NodeSet nodes_;
};

TEST_F(Circles, GetThreeNodesWhereTheyHaveNone) {
  nodes_.add_new({0, 0, 4});
  recover();
  EXPECT_GE(nodes_on(0), 3);
  EXPECT_GE(nodes_on(1), 3);
}

TEST_F(Circles, GetAThirdNodeWhereTheyHaveTwo) {
  for (const double z : {0.0, 8.0})
    for (const double x : {10.0, -10.0}) nodes_.add_new({x, 0, z}, {Support::Kind::Edge, z > 4});
  // Beside the two, so that the straight line between them is an edge of the mesh.
  for (const double y : {3.0, -3.0}) nodes_.add_new({0, y, 4});
  recover();
  EXPECT_GE(nodes_on(0), 3);
  EXPECT_GE(nodes_on(1), 3);
}

TEST_F(Circles, GetTheirThirdNodeAwayFromTheTwoThatTheyHave) {
  const double third = 2 * std::numbers::pi / 3;
  for (const double z : {0.0, 8.0})
    for (const double angle : {0.0, third})
      nodes_.add_new({10 * std::cos(angle), 10 * std::sin(angle), z}, {Support::Kind::Edge, z > 4});
  recover(true);
  EXPECT_EQ(nodes_on(0), 3);
  EXPECT_EQ(nodes_on(1), 3);
  for (std::size_t i = 0; i < nodes_.positions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(distance(nodes_.positions[i], nodes_.positions[j]), 1);
}

TEST(LensShapedFace, GetsANodeBesideTheVerticesThatItsTwoEdgesShare) {
  // A pin overhangs a plate by .3: both the arc and the plate's rim go from vertex to vertex.
  const BoundaryModel boundary =
      build_cells(evaluate(test::model_of({test::block("plate", 40, 40, 5),
                                           test::placed(test::cylinder("pin", 5, 6), 15.3, 0, 5)})),
                  kRun)
          .boundary;
  const auto ends = [&](int e) {
    return std::minmax(boundary.edges[e].start, boundary.edges[e].end);
  };
  const auto shares_ends = [&](int e) {
    for (int f = 0; f < std::ssize(boundary.edges); ++f)
      if (e != f && ends(e) == ends(f)) return true;
    return false;
  };
  std::vector<int> sides;  // the pin's rim above the plate goes from vertex to vertex too
  for (int e = 0; e < std::ssize(boundary.edges); ++e)
    if (!boundary.edges[e].closed() && boundary.edges[e].length < 5 && shares_ends(e))
      sides.push_back(e);
  ASSERT_EQ(sides.size(), 2U);
  NodeSet nodes;
  for (int v = 0; v < std::ssize(boundary.vertices); ++v)
    nodes.add_new(boundary.vertices[v].position, {Support::Kind::Vertex, v});
  DelaunayMesh mesh(boundary.bounds);
  insert_in_segments(nodes, mesh, 0, boundary, {.sizes = 20}, kRun);
  const auto nodes_on = [&](int e) {
    return std::ranges::count(nodes.supports, Support{Support::Kind::Edge, e});
  };
  EXPECT_GE(nodes_on(sides[0]) + nodes_on(sides[1]), 1);
}

constexpr double kEdgeLength = 5;

/// A straight model edge of simple-a with nodes at two places of it, and a chain broken there.
class BrokenLink : public testing::Test {
 protected:
  BrokenLink() {
    while (cells_.boundary.edges[edge_].curve.kind != Curve::Kind::Line) ++edge_;
    const auto& points = cells_.boundary.edges[edge_].points;
    const Vec3 along = normalised(points.back() - points.front());
    a_ = points.front() + 20.0 * along;
    b_ = a_ + kEdgeLength * along;
    for (const Vec3& p : {a_, b_}) nodes_.add_new(p, {Support::Kind::Edge, edge_});
    verification_.failures = {{MeshFailure::MissingSegment, edge_, 0.5 * (a_ + b_), "broken"}};
  }
  int insert() {
    return insert_where_missing(nodes_, verification_.failures, cells_.boundary, samples_,
                                kEdgeLength);
  }

  const FeatureModel model_ = evaluate(test::case_model("simple-a"));
  const CellularModel cells_ = build_cells(model_, kRun);
  const Samples samples_ =
      sample_boundary(cells_.boundary, Membership(model_), kEdgeLength, 1, {}, kRun);
  int edge_ = 0;
  Vec3 a_, b_;
  NodeSet nodes_;
  Verification verification_;
};

TEST_F(BrokenLink, IsHalvedOnItsModelEdge) {
  ASSERT_EQ(insert(), 1);
  EXPECT_EQ(nodes_.supports.back(), (Support{Support::Kind::Edge, edge_}));
  EXPECT_LT(distance(nodes_.positions.back(), 0.5 * (a_ + b_)), 1e-9);
}

TEST_F(BrokenLink, TooShortToBeHalvedGetsANodeWhereSamplesAreFarthestFromAny) {
  nodes_.add_new(0.5 * (a_ + b_), {Support::Kind::Edge, edge_});
  ASSERT_EQ(insert(), 1);
  const Vec3 p = nodes_.positions.back();
  EXPECT_NE(nodes_.supports.back().kind, Support::Kind::Interior);
  EXPECT_LE(distance(p, 0.5 * (a_ + b_)), kEdgeLength);
  EXPECT_GT(distance(p, 0.5 * (a_ + b_)), 0.8 * kEdgeLength);
}

TEST_F(BrokenLink, IsLeftAloneWhereNothingIsMissing) {
  verification_.failures.clear();
  EXPECT_EQ(insert(), 0);
}

TEST_F(BrokenLink, IsLeftAloneWhereThePartHasNoNodes) {
  nodes_.resize(0);
  EXPECT_EQ(insert(), 0);
}

/// The same with a model vertex that no node stands on.
class MissingVertex : public BrokenLink {
 protected:
  MissingVertex() { verification_.failures = {{MeshFailure::MissingVertex, 0, vertex_, "gone"}}; }

  const Vec3 vertex_ = cells_.boundary.vertices[0].position;
  const Support on_{Support::Kind::Vertex, 0};
};

TEST_F(MissingVertex, GetsANode) {
  const std::int32_t before = nodes_.size();
  EXPECT_GE(insert(), 1);
  ASSERT_GT(nodes_.size(), before);
  EXPECT_EQ(nodes_.supports[before], on_);
  EXPECT_EQ(nodes_.positions[before], vertex_);
}

TEST_F(MissingVertex, GetsTheNodeThatIsTooNearForAnother) {
  const std::int32_t near = nodes_.size();
  nodes_.add_new(vertex_ + Vec3{0.1 * kEdgeLength, 0, 0}, {Support::Kind::Edge, edge_});
  EXPECT_GE(insert(), 1);
  EXPECT_EQ(nodes_.supports[near], on_);
  EXPECT_EQ(nodes_.positions[near], vertex_);
  EXPECT_EQ(std::ranges::count(nodes_.supports, on_), 1);
}

TEST_F(MissingVertex, GetsNoSecondNode) {
  nodes_.add_new(vertex_, on_);
  insert();
  EXPECT_EQ(std::ranges::count(nodes_.supports, on_), 1);
}

}  // namespace
}  // namespace remeshd
