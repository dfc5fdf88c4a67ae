#include "tests/bench/results.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace remeshd::bench {
namespace {

using testing::DoubleEq;
using testing::Optional;

Sample sample_of(double seconds, std::uint32_t nodes = 1000) {
  return {.cpu = seconds, .nodes = nodes};
}

TEST(Results, ComeBackFromJsonAsTheyWere) {
  Sample ours = sample_of(0.25, 15155);
  ours.wall = 0.26;
  ours.strategy = "local";
  ours.iterations = 7;
  ours.free_share = 0.164;
  ours.base_kept = 0.75;
  ours.base_far = 0.5;
  ours.phases = {.setup = 1, .optimise = 2, .extract = 3, .difference = 4, .copy = 5};
  ours.tets = 72493;
  ours.peak_bytes = 31e6;
  ours.retained_bytes = 9e6;
  ours.quality.volume_length_mean = 0.873;
  ours.quality.dihedral_min = 25.3;
  Sample peer = sample_of(0.6);
  peer.import = 0.001;
  peer.geometry = 0.3;
  const Results results{
      .machine = "a machine",
      .date = "2009-08-13",
      .commands = {"remesh-bench", "remesh-bench --keep"},
      .groups = {{.name = "tool1-ac",
                  .nodes = 15000,
                  .series = {{"remesh auto", {ours, Sample{.failure = "signal 11: "}}},
                             {"hxt", {peer}}}}}};
  const nlohmann::json stored = write_results(results);
  const Results read = read_results(nlohmann::json::parse(stored.dump()));
  EXPECT_EQ(write_results(read), stored);
  EXPECT_EQ(read.machine, "a machine");
  const Group* group = read.find("tool1-ac", 15000);
  ASSERT_NE(group, nullptr);
  const Sample& again = group->series.at("remesh auto").at(0);
  EXPECT_EQ(again.phases.copy, 5);
  EXPECT_EQ(again.free_share, 0.164);
  EXPECT_EQ(again.base_kept, 0.75);
  EXPECT_EQ(again.base_far, 0.5);
  EXPECT_EQ(again.retained_bytes, 9e6);
  EXPECT_EQ(group->series.at("remesh auto").at(1).failure, "signal 11: ");
  EXPECT_EQ(group->series.at("hxt").at(0).import, 0.001);
  EXPECT_EQ(group->series.at("hxt").at(0).geometry, 0.3);
}

TEST(Results, AreFoundByCaseAndNodes) {
  const Results results{.groups = {{.name = "simple-ab", .nodes = 15000}}};
  EXPECT_NE(results.find("simple-ab", 15000), nullptr);
  EXPECT_EQ(results.find("simple-ab", 30000), nullptr);
  EXPECT_EQ(results.find("tool1-ac", 15000), nullptr);
}

TEST(Group, FailedRunsDoNotCount) {
  const Group group{
      .series = {{"remesh 10", {sample_of(1), Sample{.failure = "hung"}, sample_of(3)}},
                 {"regular 10", {sample_of(4), sample_of(5), sample_of(4)}}}};
  EXPECT_THAT(group.seconds("remesh 10"), Optional(DoubleEq(2)));
  EXPECT_THAT(group.ratio("remesh 10", "regular 10"), Optional(DoubleEq(0.5)));
  EXPECT_EQ(group.seconds("hxt"), std::nullopt);
  EXPECT_EQ(group.ratio("remesh 10", "hxt"), std::nullopt);
}

TEST(Group, APeerWithTwiceTheNodesIsComparedByTheNode) {
  const Group group{
      .series = {{"regular auto", {sample_of(1, 1000)}}, {"netgen", {sample_of(10, 2000)}}}};
  EXPECT_THAT(group.ratio_per_node("regular auto", "netgen"), Optional(DoubleEq(0.2)));
}

TEST(SeriesName, TellsTheIterations) {
  EXPECT_EQ(series_name("remesh", 10), "remesh 10");
  EXPECT_EQ(series_name("regular", 0), "regular auto");
}

}  // namespace
}  // namespace remeshd::bench
