#include "engine/remesh/finish/crowded_links.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

/// Two straight model edges that meet at 10 degrees, and a third beside the first, 0.2 away.
class ALinkBesideOthers : public testing::Test {
 protected:
  ALinkBesideOthers() {
    for (const Vec3& p :
         {Vec3{}, Vec3{10, 0, 0}, 10.0 * other_, Vec3{0, 0, kStrip}, Vec3{10, 0, kStrip}}) {
      boundary_.vertices.emplace_back();
      boundary_.vertices.back().position = p;
    }
    test::add_line(boundary_, 0, 1, {});
    test::add_line(boundary_, 0, 2, {});
    test::add_line(boundary_, 3, 4, {});
    a_ = add({2, 0, 0}, {Support::Kind::Edge, 0});
    b_ = add({4, 0, 0}, {Support::Kind::Edge, 0});
  }
  std::int32_t add(const Vec3& p, const Support& support) {
    nodes_.add_new(p, support);
    return nodes_.size() - 1;
  }
  bool clear() { return CrowdedLinks(nodes_, boundary_, sizes_).clear(0, a_, b_); }
  bool clear_missing() {
    const Vec3 middle = 0.5 * (nodes_.positions[a_] + nodes_.positions[b_]);
    return CrowdedLinks(nodes_, boundary_, sizes_)
        .clear({MeshFailure::MissingSegment, 0, middle, "broken"});
  }
  void expect_last(const Vec3& place, int edge) const {
    EXPECT_LT(distance(nodes_.positions.back(), place), 1e-9);
    EXPECT_EQ(nodes_.supports.back(), (Support{Support::Kind::Edge, edge}));
  }

  static constexpr double kAngle = std::numbers::pi / 18;
  static constexpr double kStrip = 0.2;
  const Vec3 other_{std::cos(kAngle), std::sin(kAngle), 0};
  const SizeField sizes_{2};
  BoundaryModel boundary_;
  NodeSet nodes_;
  std::int32_t a_, b_;
};

TEST_F(ALinkBesideOthers, GetsTheNodeOfAFaceThatIsInItsWay) {
  add({3.2, 0.1, 0}, {Support::Kind::Face, 0});
  EXPECT_TRUE(clear());
  EXPECT_EQ(nodes_.size(), 3);
  expect_last({3.2, 0, 0}, 0);
}

TEST_F(ALinkBesideOthers, GetsSuchANodeNoNearerToItsEndsThanAQuarterOfIt) {
  add({3.9, 0.1, 0}, {Support::Kind::Face, 0});
  EXPECT_TRUE(clear());
  expect_last({3.5, 0, 0}, 0);
}

TEST_F(ALinkBesideOthers, GetsANodeAsFarFromTheCornerAsThatOfTheOtherEdge) {
  add({}, {Support::Kind::Vertex, 0});
  add(10.0 * other_, {Support::Kind::Vertex, 2});
  add(2.7 * other_, {Support::Kind::Edge, 1});
  EXPECT_TRUE(clear());
  EXPECT_EQ(nodes_.size(), 6);
  expect_last({2.7, 0, 0}, 0);
}

TEST_F(ALinkBesideOthers, HasTheNodeAcrossAStripMovedOppositeToItsEnd) {
  add({0, 0, kStrip}, {Support::Kind::Vertex, 3});
  add({10, 0, kStrip}, {Support::Kind::Vertex, 4});
  add({2.3, 0, kStrip}, {Support::Kind::Edge, 2});
  EXPECT_TRUE(clear());
  EXPECT_EQ(nodes_.size(), 5);
  expect_last({2, 0, kStrip}, 2);
}

TEST_F(ALinkBesideOthers, LeavesThatNodeWhereThePlaceOppositeIsTaken) {
  add({2, 0, kStrip}, {Support::Kind::Edge, 2});
  add({10, 0, kStrip}, {Support::Kind::Vertex, 4});
  add({2.3, 0, kStrip}, {Support::Kind::Edge, 2});
  EXPECT_FALSE(clear());
  expect_last({2.3, 0, kStrip}, 2);
}

TEST_F(ALinkBesideOthers, LeavesInterfaceNodesOfAPatch) {
  add({3, 0.1, 0}, {Support::Kind::Face, 0});
  nodes_.interface_nodes = 3;
  EXPECT_FALSE(clear());
}

TEST_F(ALinkBesideOthers, OfNoLengthIsLeft) {
  nodes_.positions[b_] = nodes_.positions[a_];
  add(nodes_.positions[a_], {Support::Kind::Edge, 1});
  EXPECT_FALSE(clear());
  EXPECT_FALSE(clear_missing());
}

TEST_F(ALinkBesideOthers, WithNothingInItsWayIsHalvedWhereVerificationMissesIt) {
  EXPECT_FALSE(clear());
  EXPECT_TRUE(clear_missing());
  expect_last({3, 0, 0}, 0);
}

TEST_F(ALinkBesideOthers, MuchShorterThanEdgesAreToBeIsNotHalved) {
  nodes_.positions[b_] = {2.1, 0, 0};
  EXPECT_FALSE(clear_missing());
}

}  // namespace
}  // namespace remeshd
