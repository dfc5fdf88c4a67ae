#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Report;
using testing::HasSubstr;
using testing::MatchesRegex;

Report::Attempt attempt(const std::string& strategy, const std::string& reason, double seconds) {
  Report::Attempt a;
  a.set_strategy(strategy);
  a.set_reason(reason);
  a.set_seconds(seconds);
  return a;
}

/// The lines of a text.
std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

TEST_F(Cli, ExplainTellsWhatWasTriedBeforeWhatWasTakenAndWhy) {
  Report& report = service_.stored_report;
  report.set_way(Report::WAY_FRESH);
  report.mutable_seconds()->set_total(1.5);
  auto& diagnostics = *report.mutable_diagnostics();
  diagnostics.set_geometry("crossed");
  diagnostics.set_geometry_seconds(0.125);
  *diagnostics.mutable_taken() = attempt("fresh", "", 0.75);
  *diagnostics.add_geometry_attempts() =
      attempt("swept", "sweeps: two features have no axis in common", 2e-5);
  *report.add_attempts() = attempt("morphed", "a tet would have missed the goals of quality", 0.02);
  *report.add_attempts() = attempt("local, everywhere", "a hole in the boundary", 0.25);
  service_.stored_parent = "0123abcd";
  ASSERT_EQ(run({"explain", "tool1-a"}), kFine) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("edit of"));
  EXPECT_THAT(out_.str(), HasSubstr("0123abcd"));
  const auto table = lines(out_.str());
  ASSERT_EQ(table.size(), 10U) << out_.str();
  EXPECT_THAT(table[2], MatchesRegex("seconds +1.5"));
  EXPECT_THAT(table[4], MatchesRegex("step +way +outcome +seconds +reason"));
  EXPECT_THAT(table[5],
              MatchesRegex("boundary +swept +given up +<0.001 +sweeps: two features have.*"));
  EXPECT_THAT(table[6], MatchesRegex("boundary +crossed +taken +0.125 +-"));
  EXPECT_THAT(table[7], MatchesRegex("mesh +morphed +given up +0.02 +a tet would have.*"));
  EXPECT_THAT(table[8], MatchesRegex("mesh +local, everywhere +given up +0.25 +a hole.*"));
  EXPECT_THAT(table[9], MatchesRegex("mesh +fresh +taken +0.75 +-"));
}

TEST_F(Cli, ExplainTellsOfARenewalThatWasNoBetterAfterTheMeshThatStayed) {
  Report& report = service_.stored_report;
  report.set_way(Report::WAY_LOCAL);
  *report.mutable_diagnostics()->mutable_taken() = attempt("local, 8 edge lengths", "", 0.5);
  *report.add_attempts() = attempt("local, 6 edge lengths", "an inverted tet", 0.25);
  *report.add_attempts() = attempt("renewed", "no better than the mesh", 2);
  ASSERT_EQ(run({"explain", "tool1-a"}), kFine) << err_.str();
  const auto table = lines(out_.str());
  ASSERT_EQ(table.size(), 9U) << out_.str();
  EXPECT_THAT(table[6], MatchesRegex("mesh +local, 6 edge lengths +given up +0.25 +an inv.*"));
  EXPECT_THAT(table[7], MatchesRegex("mesh +local, 8 edge lengths +taken +0.5 +-"));
  EXPECT_THAT(table[8], MatchesRegex("mesh +renewed +given up +2 +no better.*"));
}

/// Such a report is in older stores.
TEST_F(Cli, ExplainNamesTheWayWhereTheReportKnowsNoMore) {
  service_.stored_report.set_way(Report::WAY_FULL);
  ASSERT_EQ(run({"explain", "tool1-a"}), kFine) << err_.str();
  EXPECT_THAT(lines(out_.str()).back(), MatchesRegex("mesh +full +taken +- +-"));
}

TEST_F(Cli, ExplainOfAFirstMeshNamesItsModel) {
  service_.stored_report.set_way(Report::WAY_TETGEN);
  ASSERT_EQ(run({"explain", "tool1-a"}), kFine) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("first mesh of"));
  EXPECT_THAT(out_.str(), HasSubstr("TetGen"));
}

}  // namespace
}  // namespace remeshd::cli
