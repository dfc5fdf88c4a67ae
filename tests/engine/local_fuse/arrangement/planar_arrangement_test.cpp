#include "engine/local_fuse/arrangement/planar_arrangement.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/cases.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::model_of;

std::optional<PlanarArrangement> outlines_of(const ModelSource& source) {
  const FeatureModel model = evaluate(source);
  const Membership membership(model);
  std::vector<int> features(model.features.size());
  std::iota(features.begin(), features.end(), 0);
  const auto sweeps = find_sweeps(model, membership, features);
  return sweeps ? arrange(*sweeps, membership, membership.bounds().diagonal()) : std::nullopt;
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

}  // namespace
}  // namespace remeshd
