#include "engine/delivery/quality_drift.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

constexpr QualityReference kRegular{.volume_length_mean = 0.82, .nodes_over_expected = 1.05};

/// The regular mesh, but for what an edit did to it.
bool drifted(double quality_lost, double nodes_over_regular, bool even = true) {
  return has_drifted({kRegular.volume_length_mean - quality_lost,
                      nodes_over_regular * kRegular.nodes_over_expected},
                     kRegular, even);
}

TEST(QualityDrift, IsNoneOfTheRegularMeshItself) { EXPECT_FALSE(drifted(0, 1)); }

TEST(QualityDrift, IsALossOfMoreThanFiveThousandthsOfTheMeanQuality) {
  EXPECT_FALSE(drifted(0.0049, 1));
  EXPECT_TRUE(drifted(0.0051, 1));
  EXPECT_FALSE(drifted(-0.1, 1)) << "better than the regular mesh";
}

TEST(QualityDrift, IsALossOfFourHundredthsWhereEdgesAreNotEven) {
  EXPECT_FALSE(drifted(0.0399, 1, false));
  EXPECT_TRUE(drifted(0.0401, 1, false));
}

TEST(QualityDrift, IsMoreThanATenthTooManyNodesOrTooFew) {
  EXPECT_FALSE(drifted(0, 1.09));
  EXPECT_TRUE(drifted(0, 1.11));
  EXPECT_FALSE(drifted(0, 0.91));
  EXPECT_TRUE(drifted(0, 0.89));
}

TEST(QualityDrift, IsToldInFigures) {
  EXPECT_EQ(describe(kRegular), "0.820 mean volume-length, 1.05 of the nodes expected");
}

}  // namespace
}  // namespace remeshd
