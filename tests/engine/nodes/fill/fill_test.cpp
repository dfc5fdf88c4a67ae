#include "engine/nodes/fill/fill.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "engine/nodes/density.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

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

using Fill = decltype(&fill_lattice);

class Filling : public testing::TestWithParam<Fill> {};
INSTANTIATE_TEST_SUITE_P(Both, Filling, testing::Values(&fill_lattice, &fill_random),
                         [](const auto& each) { return each.index == 0 ? "Lattice" : "Random"; });

TEST_P(Filling, SpreadsTheCountAskedFor) {
  const Vec3 c{5, 5, 5};
  const auto ball = [&](const Vec3& p) { return norm2(p - c) < 16; };
  const auto nodes =
      GetParam()({box({0, 0, 0}, {10, 10, 10})}, ball, {.edge_length = 0.6, .count = 2000}, kRun);
  EXPECT_NEAR(static_cast<double>(nodes.size()), 2000, 1);
  for (const Vec3& p : nodes) ASSERT_TRUE(ball(p));
}

TEST_P(Filling, TheDensityIsEven) {
  const Box cube = box({0, 0, 0}, {10, 10, 10});
  const auto nodes = GetParam()(
      {cube}, [&](const Vec3& p) { return cube.contains(p); },
      {.edge_length = 1, .density = 3, .seed = 5}, kRun);
  EXPECT_NEAR(static_cast<double>(nodes.size()), 3000, 60);
  int in_corner = 0;
  for (const Vec3& p : nodes) in_corner += p.x < 5 && p.y < 5 && p.z < 5;
  EXPECT_NEAR(in_corner, 375, 30);
}

TEST_P(Filling, OverlappingBoxesAreFilledOnce) {
  const auto everywhere = [](const Vec3&) { return true; };
  const FillOptions options{.edge_length = 1, .density = 2};
  const auto once = GetParam()({box({0, 0, 0}, {6, 6, 6})}, everywhere, options, kRun);
  const auto twice =
      GetParam()({box({0, 0, 0}, {6, 6, 6}), box({0, 0, 0}, {6, 6, 6})}, everywhere, options, kRun);
  EXPECT_EQ(once, twice);
}

TEST_P(Filling, ACountOfNoneGetsNothing) {
  const auto everywhere = [](const Vec3&) { return true; };
  EXPECT_TRUE(GetParam()({box({0, 0, 0}, {5, 5, 5})}, everywhere, {.edge_length = 1, .count = 0},
                         kRun)
                  .empty());
}

TEST_P(Filling, AnEmptyRegionGetsNothing) {
  const auto nowhere = [](const Vec3&) { return false; };
  const FillOptions options{.edge_length = 1, .density = 2};
  EXPECT_TRUE(GetParam()({box({0, 0, 0}, {5, 5, 5})}, nowhere, options, kRun).empty());
  EXPECT_TRUE(
      GetParam()({box({0, 0, 0}, {5, 5, 5})}, nowhere, {.edge_length = 1, .count = 100}, kRun)
          .empty());
}

TEST(FillLattice, AThinSlabGetsItsShareWhereverItStands) {
  const Box cube = box({0, 0, 0}, {40, 40, 40});
  for (const double z : {10.0, 10.1, 10.25, 10.5}) {
    const auto slab = [&](const Vec3& p) { return p.z > z && p.z < z + 0.1; };
    const auto nodes = fill_lattice({cube}, slab, {.edge_length = 1, .density = 1.7}, kRun);
    EXPECT_NEAR(static_cast<double>(nodes.size()), 0.1 * 40 * 40 * 1.7, 60) << z;
  }
}

TEST(FillLattice, NeighboursKeepTheirDistance) {
  const auto nodes = fill_lattice(
      {box({0, 0, 0}, {8, 8, 8})}, [](const Vec3&) { return true; },
      {.edge_length = 1, .density = 2}, kRun);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) ASSERT_GT(distance(nodes[a], nodes[b]), 0.68);
}

TEST_P(Filling, EndsSoonAfterAStopHoweverManyPlacesALayerHas) {
  std::stop_source stop;
  remeshd::Run run;
  run.stop = stop.get_token();
  std::size_t asked_since = 0;
  const auto inside = [&](const Vec3&) {
    asked_since += stop.request_stop() ? 0 : 1;
    return true;
  };
  EXPECT_THROW(GetParam()({box({0, 0, 0}, {1500, 1500, 1500})}, inside,
                          {.edge_length = 1, .density = 2}, run),
               Error);
  EXPECT_LT(asked_since, 10000U);
}

}  // namespace
}  // namespace remeshd
