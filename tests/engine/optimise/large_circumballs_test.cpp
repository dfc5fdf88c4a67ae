#include "engine/optimise/large_circumballs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace remeshd {
namespace {

bool everywhere(const Vec3&) { return true; }

/// A regular tet whose circumscribed ball has this radius, round the origin.
NodeSet corners(double radius) {
  NodeSet nodes;
  const double s = radius / std::sqrt(3.0);
  for (const Vec3& p : {Vec3{s, s, s}, Vec3{-s, -s, s}, Vec3{-s, s, -s}, Vec3{s, -s, -s}})
    nodes.add_new(p);
  return nodes;
}
const std::vector<Tet> kTet{{0, 1, 2, 3}};

TEST(FillVoids, ALargeBallGetsANodeAtItsCentre) {
  NodeSet nodes = corners(0.8);
  insert_at_circumcentres(nodes, kTet, everywhere, 1, kLargestBallEven);
  ASSERT_EQ(nodes.size(), 5);
  EXPECT_LT(norm(nodes.positions[4]), 1e-12);
  EXPECT_TRUE(nodes.is_free(4));
}

TEST(FillVoids, ABallOfTheUsualSizeDoesNot) {
  NodeSet nodes = corners(0.65);
  insert_at_circumcentres(nodes, kTet, everywhere, 1, kLargestBallEven);
  EXPECT_EQ(nodes.size(), 4);
}

TEST(FillVoids, TetsThatShareABallGetOneNode) {
  NodeSet nodes = corners(0.8);
  insert_at_circumcentres(nodes, std::vector<Tet>{kTet[0], kTet[0]}, everywhere, 1,
                          kLargestBallEven);
  EXPECT_EQ(nodes.size(), 5);
}

TEST(FillVoids, NoNodeComesOutsideOrNextToABoundary) {
  NodeSet nodes = corners(0.8);
  insert_at_circumcentres(
      nodes, kTet, [](const Vec3&) { return false; }, 1, kLargestBallEven);
  EXPECT_EQ(nodes.size(), 4);
  nodes.supports[2] = {Support::Kind::Face, 0};
  insert_at_circumcentres(nodes, kTet, everywhere, 1, kLargestBallEven);
  EXPECT_EQ(nodes.size(), 4);
}

}  // namespace
}  // namespace remeshd
