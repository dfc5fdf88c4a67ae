#include "engine/remesh/finish/opposite_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/boundary_faces.h"
#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

using test::square_face;

/// Face 0 below face 1.
class NodesOfTwoFaces : public testing::Test {
 protected:
  void use(const BoundaryFace& below, const BoundaryFace& above) {
    boundary_.faces = {below, above};
  }
  void use_film() { use(square_face(0, 0, false), square_face(0, kFilm, true)); }
  std::int32_t add(const Vec3& p, const Support& support) {
    nodes_.add_new(p, support);
    return nodes_.size() - 1;
  }
  int set() {
    const MeshDefect defect{MeshFailure::NonconformingFacet, 0, {2, 2, 0}, "on no face"};
    return OppositeNodes(nodes_, boundary_, sizes_).set({&defect, 1});
  }
  void expect_at(std::int32_t node, const Vec3& place) const {
    EXPECT_LT(distance(nodes_.positions[node], place), 1e-9);
  }

  static constexpr double kFilm = 0.2;
  static constexpr Support kBelow{Support::Kind::Face, 0}, kAbove{Support::Kind::Face, 1};
  const SizeField sizes_{2};
  BoundaryModel boundary_;
  NodeSet nodes_;
};

TEST_F(NodesOfTwoFaces, OfAFilmBecomeMirrorImages) {
  use_film();
  const std::int32_t below = add({2, 2, 0}, kBelow), above = add({2.5, 2, kFilm}, kAbove);
  nodes_.state[above] = NodeState::Frozen;
  EXPECT_EQ(set(), 1);
  expect_at(below, {2, 2, 0});
  expect_at(above, {2, 2, kFilm});
  EXPECT_TRUE(nodes_.is_free(above));
  EXPECT_EQ(set(), 0) << "they are already";
}

TEST_F(NodesOfTwoFaces, ArePairedWithTheNearest) {
  use_film();
  add({2, 2, 0}, kBelow);
  const std::int32_t far = add({2.9, 2, kFilm}, kAbove), near = add({1.8, 2, kFilm}, kAbove);
  set();
  expect_at(near, {2, 2, kFilm});
  expect_at(far, {2.9, 2, kFilm});
}

TEST_F(NodesOfTwoFaces, MoveOppositeToFixedOnes) {
  use_film();
  const std::int32_t below = add({2, 2, 0}, kBelow), above = add({2.5, 2, kFilm}, kAbove);
  nodes_.state[above] = NodeState::Fixed;
  EXPECT_EQ(set(), 1);
  expect_at(below, {2.5, 2, 0});
  nodes_.positions[below] = {2, 2, 0};
  nodes_.state[below] = NodeState::Fixed;
  EXPECT_EQ(set(), 0);
}

TEST_F(NodesOfTwoFaces, GetANewNodeOppositeWhereNoneIsNear) {
  use_film();
  add({2, 2, 0}, kBelow);
  add({3.6, 2, kFilm}, kAbove);
  ASSERT_EQ(set(), 2);
  EXPECT_EQ(nodes_.supports[2], kAbove);
  EXPECT_EQ(nodes_.supports[3], kBelow);
  expect_at(2, {2, 2, kFilm});
  expect_at(3, {3.6, 2, 0});
}

TEST_F(NodesOfTwoFaces, OfAWedgeBecomeAsFarFromItsEdge) {
  constexpr double kAngle = std::numbers::pi / 36;
  use(square_face(0, 0, false), square_face(kAngle, 0, true));
  nodes_.state[add({2, 2, 0}, kBelow)] = NodeState::Fixed;
  const std::int32_t above = add({2.4, 2, 2.4 * std::tan(kAngle)}, kAbove);
  EXPECT_EQ(set(), 1);
  expect_at(above, {2 * std::cos(kAngle), 2, 2 * std::sin(kAngle)});
}

TEST_F(NodesOfTwoFaces, AreLeftWhereTheFacesDoNotLookAtEachOther) {
  use(square_face(0, 0, true), square_face(0, kFilm, true));
  add({2, 2, 0}, kBelow);
  add({2.5, 2, kFilm}, kAbove);
  EXPECT_EQ(set(), 0);
}

TEST_F(NodesOfTwoFaces, AreLeftWhereTheFacesAreFarApart) {
  use(square_face(0, 0, false), square_face(0, 1.1, true));
  add({2, 2, 0}, kBelow);
  add({2.5, 2, 1.1}, kAbove);
  EXPECT_EQ(set(), 0);
}

/// An image would be where its node is but for rounding.
TEST_F(NodesOfTwoFaces, AreLeftWhereTheFacesAllButTouch) {
  use(square_face(0, 0, false), square_face(0, 1e-4, true));
  add({2, 2, 0}, kBelow);
  add({2.5, 2, 1e-4}, kAbove);
  EXPECT_EQ(set(), 0);
}

TEST_F(NodesOfTwoFaces, HaveNoImageWhereTheOtherFaceDoesNotReach) {
  use_film();
  boundary_.faces[1].points = {{2.2, 0, kFilm}, {9, 0, kFilm}, {9, 9, kFilm}, {2.2, 9, kFilm}};
  nodes_.state[add({2, 2, 0}, kBelow)] = NodeState::Fixed;
  nodes_.state[add({3, 2, kFilm}, kAbove)] = NodeState::Fixed;
  EXPECT_EQ(set(), 1);
  expect_at(2, {3, 2, 0});
}

/// Two nodes in one place are no Delaunay mesh.
TEST_F(NodesOfTwoFaces, DoNotMoveToWhereAnEdgeHasANode) {
  use_film();
  boundary_.vertices.resize(4);
  const auto edge = [&](int from, double z, int face) {
    boundary_.vertices[from].position = {0, 2, z};
    boundary_.vertices[from + 1].position = {9, 2, z};
    test::add_line(boundary_, from, from + 1, {face});
  };
  edge(0, 0, 0);
  edge(2, kFilm, 1);
  add({2, 2, 0}, {Support::Kind::Edge, 0});
  add({2, 2, kFilm}, {Support::Kind::Edge, 1});
  const std::int32_t above = add({2.5, 2.4, kFilm}, kAbove);
  set();
  EXPECT_GT(distance(nodes_.positions[above], {2, 2, kFilm}), 0.1);
}

TEST_F(NodesOfTwoFaces, OfAnEdgeGetAnImageOnTheOtherFace) {
  use_film();
  boundary_.vertices.resize(2);
  boundary_.vertices[1].position = {9, 2, 0};
  boundary_.vertices[0].position = {0, 2, 0};
  test::add_line(boundary_, 0, 1, {0});
  add({2, 2, 0}, {Support::Kind::Edge, 0});
  const std::int32_t above = add({2.5, 2, kFilm}, kAbove);
  EXPECT_EQ(set(), 1);
  expect_at(above, {2, 2, kFilm});
}

}  // namespace
}  // namespace remeshd
