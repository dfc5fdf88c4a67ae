#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Warning;
using testing::ElementsAre;
using testing::HasSubstr;

Warning emptied() {
  Warning warning;
  warning.set_code(Warning::GROUP_EMPTIED);
  warning.set_message("the group hole.wall is gone");
  warning.add_features("hole");
  warning.add_groups("hole.wall");
  for (const double c : {1.0, 2.0, 3.5}) warning.add_point(c);
  return warning;
}

TEST_F(Cli, WritesWarningsAsObjectsAndShowsTheirSentences) {
  service_.warnings = {emptied()};
  ASSERT_EQ(run({"edit", "simple", kCases + "/simple-ab.edit.json", "-o", file("m.vtu"), "--json",
                 file("r.json")}),
            kFine);
  EXPECT_EQ(read_json("r.json")["warnings"], nlohmann::json::parse(R"([{"code": "GROUP_EMPTIED",
                                       "message": "the group hole.wall is gone",
                                       "features": ["hole"], "groups": ["hole.wall"],
                                       "point": [1.0, 2.0, 3.5], "nodes_needed": 0}])"));
  EXPECT_THAT(err_.str(), HasSubstr("warning: the group hole.wall is gone\n"));
}

TEST_F(Cli, SaysWhichStepOfASweepAWarningIsOf) {
  service_.warnings = {emptied()};
  ASSERT_EQ(run({"sweep", "simple", "top_x", "1", "2", "2"}), kFine);
  EXPECT_THAT(err_.str(), HasSubstr("warning (step 2): the group hole.wall is gone\n"));
}

TEST_F(Cli, ShowsWhatIsKnownBeforeMeshing) {
  service_.warnings = {emptied()};
  ASSERT_EQ(run({"validate", kCases + "/simple-a.json", "--json", file("v.json")}), kFine);
  EXPECT_THAT(err_.str(), HasSubstr("warning: the group hole.wall is gone\n"));
  EXPECT_EQ(read_json("v.json")["warnings"][0]["code"], "GROUP_EMPTIED");
  EXPECT_EQ(read_json("v.json")["volume"], 258000.0);
}

TEST_F(Cli, WritesWhichStrategiesWereTriedBefore) {
  auto& attempt = service_.attempts.emplace_back();
  attempt.set_strategy("local, 4 edge lengths");
  attempt.set_reason("a facet is missing");
  attempt.set_seconds(0.25);
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu"), "--json", file("r.json")}),
            kFine);
  EXPECT_EQ(read_json("r.json")["attempts"],
            nlohmann::json::parse(R"([{"strategy": "local, 4 edge lengths",
                                       "reason": "a facet is missing", "seconds": 0.25}])"));
}

TEST_F(Cli, SendsTheWarningsThatAreToBeErrors) {
  const std::string model = kCases + "/simple-a.json";
  ASSERT_EQ(run({"mesh", "--fail-on", "GROUP_EMPTIED,FALLBACK", model, "-o", file("m.vtu")}), kFine)
      << err_.str();
  EXPECT_THAT(service_.requests[0].create().options().fail_on(),
              ElementsAre(Warning::GROUP_EMPTIED, Warning::FALLBACK));
  // They are not inherited: an edit of a model file has them beside its base.
  ASSERT_EQ(run({"edit", model, kCases + "/simple-ab.edit.json", "--nodes", "900", "--fail-on",
                 "RENEWED", "-o", file("m.vtu")}),
            kFine);
  EXPECT_THAT(service_.requests[1].create().options().fail_on(), ElementsAre(Warning::RENEWED));
  EXPECT_THAT(service_.requests[2].edit().options().fail_on(), ElementsAre(Warning::RENEWED));
  EXPECT_EQ(service_.requests[2].edit().options().nodes(), 0U);
  EXPECT_EQ(run({"mesh", model, "-o", file("m.vtu"), "--fail-on", "NO_SUCH"}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("GROUP_EMPTIED, FACE_LOST"));
  EXPECT_EQ(run({"mesh", model, "-o", file("m.vtu"), "--fail-on", "CODE_UNSPECIFIED"}), kUsage);
}

TEST_F(Cli, TakesEveryLossForAnErrorWhereItIsStrict) {
  const std::string model = kCases + "/simple-a.json";
  ASSERT_EQ(run({"mesh", "--strict", "--fail-on", "RENEWED,FACE_LOST", model, "-o", file("m.vtu")}),
            kFine);
  EXPECT_THAT(service_.requests[0].create().options().fail_on(),
              ElementsAre(Warning::RENEWED, Warning::FACE_LOST, Warning::GROUP_EMPTIED,
                          Warning::FEATURE_WITHOUT_EFFECT, Warning::CHORDS_COARSE,
                          Warning::DETAIL_NOT_RESOLVED, Warning::EDGES_STRAIGHT));
  ASSERT_EQ(run({"mesh", "--strict", model, "-o", file("m.vtu")}), kFine);
  EXPECT_EQ(service_.requests[1].create().options().fail_on_size(), 6);
}

}  // namespace
}  // namespace remeshd::cli
