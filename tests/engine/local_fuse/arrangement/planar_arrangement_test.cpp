#include "engine/local_fuse/arrangement/planar_arrangement.h"

#include <gtest/gtest.h>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::feature;
using test::FuseInput;
using test::model_of;
using test::placed;
using test::reason_of;

Tried<PlanarArrangement> outlines_of(const ModelSource& source) {
  const FuseInput in(source);
  const auto sweeps = find_sweeps(in.model, in.membership, in.features);
  if (!sweeps) return sweeps.why();
  return arrange(*sweeps, in.membership, in.membership.bounds().diagonal());
}

/// Why sides that were made by hand have no arrangement, in a length of 10.
std::string no_arrangement_for(std::vector<SweepSide> sides) {
  const Membership membership(evaluate(model_of({block("any", 1, 1, 1)})));
  return reason_of(arrange({{}, {Sweep{.sides = std::move(sides)}}}, membership, 10));
}

TEST(OutlinesTest, OverlappingSidesAreOnePieceAndCrossingOnesAreSplit) {
  // A square with a bar from rim to rim, and one that sticks out.
  const auto bar = outlines_of(model_of({block("a", 10, 10, 1), block("b", 2, 10, 1)}));
  ASSERT_TRUE(bar);
  EXPECT_EQ(bar->nodes.size(), 8U);
  EXPECT_EQ(bar->pieces.size(), 10U);
  const auto cross = outlines_of(model_of({block("a", 10, 10, 1), block("b", 2, 12, 1)}));
  ASSERT_TRUE(cross);
  EXPECT_EQ(cross->nodes.size(), 12U);
  EXPECT_EQ(cross->pieces.size(), 16U);
}

TEST(OutlinesTest, CirclesThatCoincideAreOne) {
  FeatureSource upside_down = cylinder("d", 2, 1);
  upside_down.placement.z_axis = {0.0, 0.0, -1.0};
  upside_down.placement.x_axis = {1.0, 0.0, 0.0};
  const auto arrangement = outlines_of(
      model_of({block("a", 10, 10, 1), cylinder("b", 2, 1), cylinder("c", 2, 4), upside_down}));
  ASSERT_TRUE(arrangement);
  EXPECT_EQ(arrangement->pieces.size(), 5U);
  EXPECT_EQ(arrangement->pieces.back().left, (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(arrangement->pieces.back().right, std::vector{0});
}

TEST(OutlinesTest, WhatIsNeitherClearlyTogetherNorClearlyApartIsGivenUp) {
  const auto with = [](const FeatureSource& f) {
    return reason_of(outlines_of(model_of({block("plate", 20, 20, 2), f})));
  };
  const std::string corners =
      "planar_arrangement: two nodes are neither clearly the same nor clearly apart";
  const std::string sides = "planar_arrangement: the end of a side nearly touches another side";
  EXPECT_EQ(with(placed(block("all", 20, 20, 4), 1e-7, 0, 0)), corners);
  EXPECT_EQ(with(placed(block("step", 20, 4, 4), 1e-7, 0, 0)), sides);
  EXPECT_EQ(with(block("step", 20, 4, 4)), "") << "flush";
}

TEST(OutlinesTest, RoundSidesThatMeetOthersAreGivenUp) {
  const auto with = [](const FeatureSource& f) {
    return reason_of(outlines_of(model_of({block("plate", 20, 20, 2), cylinder("pin", 3, 4), f})));
  };
  const std::string meets =
      "planar_arrangement: a round side meets or nearly meets a side of another outline";
  EXPECT_EQ(with(placed(cylinder("other", 3, 4), 5, 0, 0)), meets) << "two circles cross";
  EXPECT_EQ(with(placed(cylinder("other", 3, 4), 7, 0, 0)), meets) << "a circle touches a line";
  EXPECT_EQ(with(placed(cylinder("other", 2, 4), 7, 0, 0)), "") << "clear of both";
}

TEST(OutlinesTest, AnArcAsLongAsRoundingIsGivenUp) {
  const Vec3 from{1, 0, 0}, to{1, 1e-13, 0};
  EXPECT_EQ(no_arrangement_for({{.from = from, .to = to, .round = true, .radius = 1}}),
            "planar_arrangement: the ends of an arc are one node");
}

TEST(OutlinesTest, VeryManySidesOrCrossingsAreGivenUp) {
  EXPECT_EQ(no_arrangement_for(std::vector<SweepSide>(1501)),
            "planar_arrangement: the outlines have too many sides");
  std::vector<SweepSide> grid;
  for (int k = 0; k < 100; ++k) {
    const double at = 0.1 * (k + 1);
    grid.push_back({.from = {at, 0, 0}, .to = {at, 11, 0}});
    grid.push_back({.from = {0, at, 0}, .to = {11, at, 0}});
  }
  EXPECT_EQ(no_arrangement_for(grid),
            "planar_arrangement: the sides have too many ends and crossings");
}

}  // namespace
}  // namespace remeshd
