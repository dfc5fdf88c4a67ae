#include "tests/bench/statistics.h"

#include <gmock/gmock.h>

namespace remeshd::bench {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::Optional;

TEST(Median, IsTheMiddleValueOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_THAT(median({3, 1, 2}), Optional(2.0));
  EXPECT_THAT(median({4, 1, 3, 2}), Optional(2.5));
  EXPECT_THAT(median({7}), Optional(7.0));
  EXPECT_EQ(median({}), std::nullopt);
}

TEST(Median, IsNotMovedByOneDisturbedRun) { EXPECT_THAT(median({1, 1, 1, 1, 100}), Optional(1.0)); }

TEST(PairwiseRatio, IsTheMedianOfTheRoundsRatios) {
  // The ratio of the medians would be 2 / 10.
  EXPECT_THAT(pairwise_ratio({{1.0, 2.0, 30.0}}, {{10.0, 4.0, 40.0}}), Optional(DoubleEq(0.5)));
}

TEST(PairwiseRatio, LeavesOutRoundsThatLackOneRun) {
  EXPECT_THAT(pairwise_ratio({{1.0, {}, 3.0}}, {{2.0, 4.0, {}}}), Optional(DoubleEq(0.5)));
  EXPECT_THAT(pairwise_ratio({{1.0, 9.0}}, {{2.0}}), Optional(DoubleEq(0.5)));
  EXPECT_EQ(pairwise_ratio({{1.0}}, {{std::nullopt}}), std::nullopt);
  EXPECT_EQ(pairwise_ratio({}, {}), std::nullopt);
}

TEST(Present, HasTheValuesThereAre) {
  EXPECT_THAT(present({{1.0, {}, 3.0}}), ElementsAre(1.0, 3.0));
}

}  // namespace
}  // namespace remeshd::bench
