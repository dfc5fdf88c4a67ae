#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using client::make_error;
using remesh::v1::Error;
using testing::HasSubstr;
using testing::SizeIs;

const std::string kEdit = kCases + "/simple-ab.edit.json";

TEST_F(Cli, SaysThatTheHeadStayedWhereAnotherEditMovedIt) {
  service_.head_conflict = true;
  ASSERT_EQ(run({"edit", "simple", kCases + "/simple-ab.edit.json", "-o", file("m.vtu")}), kFine);
  EXPECT_THAT(err_.str(), HasSubstr("the head of d stays at 9"));
}

TEST_F(Cli, HeadShowsTheHeadOfADesign) {
  ASSERT_EQ(run({"head", "tool1-a"}), kFine) << err_.str();
  EXPECT_EQ(out_.str(), "tool1-a@7  id-of-tool1-a\n");
  EXPECT_THAT(service_.heads, SizeIs(0));
}

TEST_F(Cli, HeadOfANumberMakesThatRevisionTheHead) {
  ASSERT_EQ(run({"head", "tool1-a@2"}), kFine) << err_.str();
  ASSERT_THAT(service_.heads, SizeIs(1));
  EXPECT_EQ(service_.heads[0].revision(), "tool1-a@2");
  EXPECT_EQ(service_.heads[0].design(), "");
  EXPECT_EQ(out_.str(), "d@2  id-of-tool1-a@2\n");
}

TEST_F(Cli, HeadTakesARevisionOfTheDesignByAnyName) {
  ASSERT_EQ(run({"head", "tool1-a", "0123abcd"}), kFine) << err_.str();
  ASSERT_THAT(service_.heads, SizeIs(1));
  EXPECT_EQ(service_.heads[0].revision(), "0123abcd");
  EXPECT_EQ(service_.heads[0].design(), "tool1-a");
}

TEST_F(Cli, MeshMakesItsRevisionTheHeadWhereAsked) {
  const std::string model = kCases + "/simple-a.json";
  ASSERT_EQ(run({"mesh", model, "--head", "-o", file("m.vtu")}), kFine) << err_.str();
  ASSERT_EQ(run({"mesh", model, "-o", file("m.vtu")}), kFine) << err_.str();
  EXPECT_TRUE(service_.requests[0].create().head().advance());
  EXPECT_FALSE(service_.requests[1].create().has_head());
  EXPECT_EQ(run({"mesh", model, "--head", "--keep-head", "-o", file("m.vtu")}), kUsage);
}

TEST_F(Cli, ShowsHowToMoveAHeadThatAFirstMeshLeft) {
  auto& warning = service_.warnings.emplace_back();
  warning.set_code(remesh::v1::Warning::HEAD_KEPT);
  warning.set_message("the head of d stays at 2; remesh head d@3 moves it");
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu"), "--json", file("r.json")}),
            kFine);
  EXPECT_THAT(err_.str(), HasSubstr("warning: the head of d stays at 2; remesh head d@3 moves it"));
  EXPECT_EQ(read_json("r.json")["warnings"][0]["code"], "HEAD_KEPT");
}

TEST_F(Cli, EditThatRequiresTheHeadExits6WhereAnotherEditMovedIt) {
  ASSERT_EQ(run({"edit", "simple", kEdit, "--require-head", "-o", file("m.vtu")}), kFine);
  EXPECT_TRUE(service_.requests[0].edit().head().require());
  EXPECT_FALSE(service_.requests[0].edit().head().has_advance());
  service_.stream_errors[0] = make_error(Error::CODE_ABORTED, Error::HEAD_CONFLICT);
  EXPECT_EQ(run({"edit", "simple", kEdit, "--require-head", "-o", file("n.vtu")}), kBusy);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "n.vtu"));
}

TEST_F(Cli, EditRequiresTheHeadOnlyWhereAsked) {
  ASSERT_EQ(run({"edit", "simple", kEdit, "-o", file("m.vtu")}), kFine);
  EXPECT_FALSE(service_.requests[0].edit().head().require());
}

TEST_F(Cli, RemakeMakesItsRevisionTheHeadWhereAsked) {
  ASSERT_EQ(run({"remake", "tool1-a@2", "--head", "--design", "mine"}), kFine) << err_.str();
  EXPECT_EQ(out_.str(), "d@1  rev-1\n");
  EXPECT_THAT(err_.str(), HasSubstr("made anew for it: 0123456789ab\n"));
  ASSERT_EQ(run({"remake", "tool1-a@2"}), kFine) << err_.str();
  ASSERT_THAT(service_.remakes, SizeIs(2));
  EXPECT_EQ(service_.remakes[0].revision(), "tool1-a@2");
  EXPECT_EQ(service_.remakes[0].design(), "mine");
  EXPECT_TRUE(service_.remakes[0].head().advance());
  EXPECT_FALSE(service_.remakes[1].has_head());
}

TEST_F(Cli, RemakeSaysThatTheHeadStayedWhereItWasMovedMeanwhile) {
  ASSERT_EQ(run({"remake", "tool1-a@2", "--head"}), kFine) << err_.str();
  EXPECT_EQ(err_.str().find("stays"), std::string::npos);
  service_.head_conflict = true;
  ASSERT_EQ(run({"remake", "tool1-a@2", "--head"}), kFine) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("the head of d stays at 9: another one became it meanwhile\n"));
}

TEST_F(Cli, RemovesAWholeDesign) {
  ASSERT_EQ(run({"rm", "--design", "tool1-a"}), kFine) << err_.str();
  ASSERT_THAT(service_.design_deletions, SizeIs(1));
  EXPECT_EQ(service_.design_deletions[0].design(), "tool1-a");
  EXPECT_EQ(err_.str(), "removed tool1-a with its 3 revisions and 2 meshes\n");
  EXPECT_EQ(run({"rm", "--design", "tool1-a", "tool1-a@1"}), kUsage);
  EXPECT_EQ(run({"rm"}), kUsage);
  EXPECT_THAT(service_.deletions, SizeIs(0));
}

}  // namespace
}  // namespace remeshd::cli
