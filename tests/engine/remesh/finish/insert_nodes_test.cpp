#include "engine/remesh/finish/insert_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

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
  void recover() {
    Box bounds;
    bounds.add(boundary_.bounds.lo);
    bounds.add(boundary_.bounds.hi);
    DelaunayMesh mesh(bounds);
    insert_in_segments(nodes_, mesh, 0, boundary_, {.sizes = 20}, kRun);
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

}  // namespace
}  // namespace remeshd
