#include "tests/bench/tables.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace remeshd::bench {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Sample ours(double seconds, std::uint32_t iterations) {
  Sample s{.cpu = seconds, .nodes = 15155, .tets = 72608, .iterations = iterations};
  s.strategy = "local";
  s.free_share = .164;
  s.phases.optimise = .257;
  return s;
}

const Results& example_results() {
  static const Results results{
      .machine = "a machine",
      .date = "2009-08-13",
      .commands = {"remesh-bench --cases tool1-ac"},
      .groups = {{.name = "tool1-ac",
                  .nodes = 15000,
                  .series = {{"regular 10", {ours(.5, 10)}},
                             {"remesh 10", {ours(.125, 10)}},
                             {"regular auto", {ours(.4, 5)}},
                             {"remesh auto", {ours(.1, 7)}},
                             {"hxt", {{.cpu = .8, .surface = .5, .import = .002, .nodes = 15262}}},
                             {"netgen", {{.cpu = 12, .nodes = 30310}}},
                             {"delaunay", {{.failure = "killed after its time: "}}}}}}};
  return results;
}

TEST(TimingTable, HasARowForEachNumberOfIterations) {
  const std::vector<std::string> lines = lines_of(timing_table(example_results()));
  ASSERT_THAT(lines, SizeIs(4));
  // The paper's 17.98 %, phi.
  EXPECT_THAT(lines[2],
              HasSubstr("| tool1-ac | 15,155 | 10 | 0.500 | 0.125 | **25.0** | 18.0 | 16.4 |"));
  EXPECT_THAT(lines[3],
              HasSubstr("| tool1-ac | 15,155 | auto (5, 7) | 0.400 | 0.100 | **25.0** | – |"));
}

TEST(TimingTable, RowsHaveAsManyCellsAsTheHead) {
  const auto bars = [](const std::string& line) { return std::ranges::count(line, '|'); };
  for (const std::string& table :
       {timing_table(example_results()), peer_table(example_results())}) {
    const std::vector<std::string> lines = lines_of(table);
    for (const std::string& line : lines) EXPECT_EQ(bars(line), bars(lines.front())) << line;
  }
}

TEST(PeerTable, ComparesAtTheSameNodesOrByTheNode) {
  const std::string table = peer_table(example_results());
  EXPECT_THAT(table,
              HasSubstr("| tool1-ac | Gmsh HXT, optimised | 15,262 | 0 | 0.800 | 0.500 | 0.002 | "
                        "0.50 | 0.125 |"));
  EXPECT_THAT(table, HasSubstr("| 0.07 a node | 0.017 a node |"));
}

TEST(Report, TellsMachineDateCommandAndWhatFailed) {
  const std::string text = report(example_results());
  EXPECT_THAT(text, HasSubstr("a machine, 2009-08-13"));
  EXPECT_THAT(text, HasSubstr("    remesh-bench --cases tool1-ac\n"));
  EXPECT_THAT(text, HasSubstr("- tool1-ac 15000 delaunay, 1 of 1: killed after its time: \n"));
  EXPECT_THAT(text, Not(HasSubstr("### Chains")));
}

TEST(BetweenMarks, KeepsTheRestOfTheDocument) {
  const std::string before = "# Title\n<!-- remesh-bench begin -->\n",
                    after = "<!-- remesh-bench end -->\nMore.\n";
  EXPECT_EQ(between_marks(before + "stale\n" + after, "| fresh |\n"),
            before + "| fresh |\n" + after);
  EXPECT_EQ(between_marks("# Title\n", "| fresh |\n"), std::nullopt);
}

TEST(ChainTable, ShowsTheWaysAndWhatARevisionKeeps) {
  Sample chain = ours(.11, 10);
  chain.strategy = "19 local, 1 renewed";
  chain.retained_bytes = 600 * 15155;
  const Results results{.groups = {{.name = "tool1-ac",
                                    .nodes = 15000,
                                    .series = {{"single", {ours(.1, 10)}}, {"chain", {chain}}}}}};
  EXPECT_THAT(
      chain_table(results),
      HasSubstr("| tool1-ac | 15,155 | 0.100 | 0.110 | 1.10 | 19 local, 1 renewed | 600 |"));
}

TEST(GoalTable, CountsAndMarksWhatIsMissed) {
  const std::string table = goal_table(
      {{.group = "a / b", .where = "tool1-ac 15k", .measured = .333, .limit = .25, .stretch = .125},
       {.group = "share",
        .where = "simple-ab 15k",
        .measured = .1,
        .limit = .17,
        .unit = Goal::Unit::Percent},
       {.group = "bytes", .where = "simple-ab 1M", .limit = 1500, .unit = Goal::Unit::Bytes}});
  EXPECT_THAT(table, HasSubstr("3 goals: 1 met, 0 of them with their stretch goal, 1 missed, "
                               "1 not measured."));
  EXPECT_THAT(table, HasSubstr("| a / b | tool1-ac 15k | 0.33 | 0.25 | 0.12 | **missed** |"));
  EXPECT_THAT(table, HasSubstr("| share | simple-ab 15k | 10.0 % | 17.0 % | – | met |"));
  EXPECT_THAT(table, HasSubstr("\nNot measured: bytes of simple-ab 1M.\n"));
}

}  // namespace
}  // namespace remeshd::bench
