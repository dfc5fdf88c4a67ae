#include "tests/bench/goals.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace remeshd::bench {
namespace {

using testing::DoubleNear;
using testing::Optional;

Results of(Group group) { return {.groups = {std::move(group)}}; }

Goal goal(const Results& results, const std::string& group, const std::string& where) {
  for (const Goal& g : judge(results))
    if (g.group.starts_with(group) && g.where == where) return g;
  ADD_FAILURE() << "no goal " << group << " " << where;
  return {};
}

Sample took(double seconds) { return {.cpu = seconds, .nodes = 1000}; }

TEST(Goal, IsMetAtItsLimitAndMissedAboveIt) {
  EXPECT_EQ((Goal{.measured = 1.0, .limit = 1.0}.outcome()), Outcome::Met);
  EXPECT_EQ((Goal{.measured = 1.01, .limit = 1.0}.outcome()), Outcome::Missed);
  EXPECT_EQ((Goal{.measured = .5, .limit = 1.0, .stretch = .5}.outcome()), Outcome::StretchMet);
  EXPECT_EQ((Goal{.measured = .6, .limit = 1.0, .stretch = .5}.outcome()), Outcome::Met);
  EXPECT_EQ((Goal{.measured = .6, .stretch = .5}.outcome()), Outcome::Missed);
  EXPECT_EQ((Goal{.limit = 1.0}.outcome()), Outcome::NotMeasured);
}

TEST(Goals, NothingIsMetByNothing) {
  const std::vector<Goal> goals = judge({});
  EXPECT_GT(goals.size(), 50U);
  EXPECT_TRUE(std::ranges::all_of(
      goals, [](const Goal& g) { return g.outcome() == Outcome::NotMeasured; }));
}

TEST(Goals, ARegularRunAgainstHxt) {
  const Results results =
      of({.name = "tool1-ac",
          .nodes = 15000,
          .series = {{"regular auto", {took(.4), took(.4)}}, {"hxt", {took(1), took(.8)}}}});
  const Goal g = goal(results, "regular auto / HXT", "tool1-ac 15k");
  EXPECT_THAT(g.measured, Optional(DoubleNear(.45, 1e-12)));
  EXPECT_EQ(g.outcome(), Outcome::StretchMet);
}

TEST(Goals, ARemeshIsAllowedTimeInProportionToItsFreeNodes) {
  Sample remesh = took(.2);
  remesh.free_share = .16;
  const Results results = of({.name = "tool1-ac",
                              .nodes = 30000,
                              .series = {{"remesh 10", {remesh}}, {"regular 10", {took(1)}}}});
  const Goal g = goal(results, "remesh / regular, 10 iterations: 1.25 phi", "tool1-ac 30k");
  EXPECT_THAT(g.measured, Optional(DoubleNear(.2, 1e-12)));
  EXPECT_THAT(g.limit, Optional(DoubleNear(.22, 1e-12)));
  EXPECT_THAT(g.stretch, Optional(DoubleNear(.128, 1e-12)));
  EXPECT_EQ(g.outcome(), Outcome::Met);
  EXPECT_EQ(goal(results, "phi", "tool1-ac 30k").outcome(), Outcome::Met);
}

TEST(Goals, ThePapersRatioIsAgainstARegularRunAsThePaperHasIt) {
  const Results results =
      of({.name = "simple-ab",
          .nodes = 30000,
          .series = {
              {"remesh 10", {took(.06)}}, {"regular 10", {took(.1)}}, {"paper 10", {took(1)}}}});
  const Goal g = goal(results, "remesh / paper's regular run", "simple-ab 30k");
  EXPECT_THAT(g.measured, Optional(DoubleNear(.06, 1e-12)));
  EXPECT_EQ(g.outcome(), Outcome::Met);
}

TEST(Goals, MemoryIsJudgedByTheNode) {
  Sample regular = took(60);
  regular.nodes = 1'000'000;
  regular.peak_bytes = 1.6e9;
  Sample chain = took(.2);
  chain.nodes = 15'000;
  chain.retained_bytes = 600 * 15'000;
  EXPECT_EQ(
      goal(of({.name = "simple-ab", .nodes = 1'000'000, .series = {{"regular 10", {regular}}}}),
           "peak", "simple-ab 1M")
          .outcome(),
      Outcome::Missed);
  EXPECT_EQ(goal(of({.name = "simple-ab", .nodes = 15'000, .series = {{"chain", {chain}}}}),
                 "memory that stays", "simple-ab 15k")
                .outcome(),
            Outcome::Met);
}

}  // namespace
}  // namespace remeshd::bench
