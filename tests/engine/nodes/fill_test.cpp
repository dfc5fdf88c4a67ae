#include "engine/nodes/fill.h"

#include <gtest/gtest.h>

#include "engine/nodes/density.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

Box box(Vec3 lo, Vec3 hi) {
  Box b;
  b.add(lo);
  b.add(hi);
  return b;
}

TEST(Density, EdgeLengthAndNodeCountAreInverse) {
  for (const double nodes : {50.0, 3000.0, 15000.0, 1e6})
    EXPECT_NEAR(expected_nodes(258000, 25000, edge_length_for(258000, 25000, nodes)), nodes,
                1e-6 * nodes);
}

TEST(Fill, SpreadsTheCountAskedFor) {
  const Vec3 c{5, 5, 5};
  const auto ball = [&](const Vec3& p) { return norm2(p - c) < 16; };
  const auto nodes =
      fill({box({0, 0, 0}, {10, 10, 10})}, ball, {.edge_length = 0.6, .count = 2000}, kRun);
  EXPECT_NEAR(static_cast<double>(nodes.size()), 2000, 1);
  for (const Vec3& p : nodes) ASSERT_TRUE(ball(p));
}

TEST(Fill, TheDensityIsEven) {
  const Box cube = box({0, 0, 0}, {10, 10, 10});
  const auto nodes = fill(
      {cube}, [&](const Vec3& p) { return cube.contains(p); },
      {.edge_length = 1, .density = 3, .seed = 5}, kRun);
  EXPECT_NEAR(static_cast<double>(nodes.size()), 3000, 60);
  int in_corner = 0;
  for (const Vec3& p : nodes) in_corner += p.x < 5 && p.y < 5 && p.z < 5;
  EXPECT_NEAR(in_corner, 375, 30);
}

TEST(Fill, OverlappingBoxesAreFilledOnce) {
  const auto everywhere = [](const Vec3&) { return true; };
  const FillOptions options{.edge_length = 1, .density = 2};
  const auto once = fill({box({0, 0, 0}, {6, 6, 6})}, everywhere, options, kRun);
  const auto twice =
      fill({box({0, 0, 0}, {6, 6, 6}), box({0, 0, 0}, {6, 6, 6})}, everywhere, options, kRun);
  EXPECT_EQ(once, twice);
}

TEST(Fill, AnEmptyRegionGetsNothing) {
  EXPECT_TRUE(fill(
                  {box({0, 0, 0}, {5, 5, 5})}, [](const Vec3&) { return false; },
                  {.edge_length = 1, .density = 2}, kRun)
                  .empty());
}

}  // namespace
}  // namespace remeshd
