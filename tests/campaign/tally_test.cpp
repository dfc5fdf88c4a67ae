#include "tests/campaign/tally.h"

#include <gtest/gtest.h>

namespace remeshd::campaign {
namespace {

TEST(Results, CountMeshesWithFlatTetsAndThoseThatLostNodesFarAway) {
  Results results;
  Outcome outcome{.kind = "valid", .strategy = "local"};
  outcome.away_angle = 20;
  results.add(outcome);
  outcome.away_angle = 4;
  outcome.lost.all = 5;
  results.add(outcome);
  outcome.lost.far = 2;
  results.add(outcome);
  EXPECT_EQ(results.away_below_5, 2);
  EXPECT_EQ(results.far_lost, 1);
  EXPECT_EQ(results.away_angle, 4);
}

}  // namespace
}  // namespace remeshd::campaign
