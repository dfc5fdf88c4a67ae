#include "client/cli/sweep_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/cli/exit_code.h"
#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

TEST(SweepGrid, ValuesAreARangeOrAList) {
  EXPECT_THAT(parse_swept("wall=6:10:5").values, ElementsAre(6, 7, 8, 9, 10));
  EXPECT_EQ(parse_swept("hole.radius=4").name, "hole.radius");
  EXPECT_THAT(parse_swept("r=4,-5e-1,6").values, ElementsAre(4, -0.5, 6));
  EXPECT_THAT(parse_swept("r=4:9:1").values, ElementsAre(4));
  for (const char* wrong : {"r", "=1", "r=", "r=1,,2", "r=1:2", "r=1:2:0", "r=1:2:2.5", "r=1:2:3:4",
                            "r=inf", "r=a", "r=1:nan:3", "r=1:2:2000000"})
    EXPECT_THROW(parse_swept(wrong), UsageError) << wrong;
}

TEST(SweepGrid, NeighboursDifferInOneValueByOnePlace) {
  const std::vector<SweptParameter> swept{{"a", {1, 2, 3}}, {"b", {10, 20}}, {"c", {5, 6, 7}}};
  ASSERT_EQ(count_combinations(swept), 18U);
  std::set<std::vector<double>> all;
  for (std::uint64_t step = 0; step < 18; ++step) {
    const auto now = combination(swept, step);
    all.insert(now);
    if (step == 0) continue;
    const auto before = combination(swept, step - 1);
    int moved = 0;
    for (std::size_t k = 0; k < swept.size(); ++k) {
      const auto& values = swept[k].values;
      moved += std::abs(static_cast<int>(std::ranges::find(values, now[k]) -
                                         std::ranges::find(values, before[k])));
    }
    EXPECT_EQ(moved, 1) << step;
  }
  EXPECT_THAT(all, SizeIs(18));
  EXPECT_THAT(combination(swept, 0), ElementsAre(1, 10, 5));
}

TEST(SweepGrid, TooManyStepsAndAParameterNamedTwiceAreRefused) {
  const std::vector<double> many(2000, 1.0);
  EXPECT_THROW(count_combinations({{"a", many}, {"b", many}}), UsageError);
  EXPECT_THROW(count_combinations({{"a", {1}}, {"a", {2}}}), UsageError);
}

TEST_F(Cli, SweepsSeveralParametersOverAllCombinations) {
  ASSERT_EQ(run({"sweep", "simple", "--set", "a=1,2", "--set", "hub.radius=3:5:3"}), kFine)
      << err_.str();
  ASSERT_THAT(service_.requests, SizeIs(6));
  EXPECT_EQ(service_.requests[3].edit().base(), "rev-3");
  const auto& edits = service_.requests[3].edit().edit().edits();
  EXPECT_EQ(edits[0].set_parameter().value().number_value(), 2);
  EXPECT_EQ(edits[1].set_feature_parameter().value().number_value(), 5);
  for (const auto& request : service_.requests) {
    EXPECT_TRUE(request.edit().head().has_advance() && !request.edit().head().advance());
    EXPECT_TRUE(request.edit().head().has_file() && !request.edit().head().file());
  }
  const auto table = rows();
  ASSERT_THAT(table, SizeIs(7));
  EXPECT_THAT(table[0], SizeIs(18));
  EXPECT_EQ(table[0][1] + " " + table[0][2] + " " + table[0][3], "a hub.radius status");
  EXPECT_EQ(table[4][1] + " " + table[4][2], "2 5");
}

TEST_F(Cli, ASweepTakesOneParameterOrSets) {
  EXPECT_EQ(run({"sweep", "simple"}), kUsage);
  EXPECT_EQ(run({"sweep", "simple", "a", "1", "2"}), kUsage);
  EXPECT_EQ(run({"sweep", "simple", "a", "1", "2", "2", "--set", "b=1"}), kUsage);
  EXPECT_EQ(run({"sweep", "simple", "--set", "b=1:2"}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("--set b=1:2"));
  EXPECT_EQ(run({"sweep", "simple", "--set", "topx=1,2"}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("did you mean `top_x`?"));
  EXPECT_THAT(service_.requests, SizeIs(0));
}

}  // namespace
}  // namespace remeshd::cli
