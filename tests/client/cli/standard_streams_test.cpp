#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/formats/read_mesh.h"
#include "remeshd/mesh_file.h"
#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

const std::string kModel = kCases + "/simple-a.json";

TEST_F(Cli, ReadsAModelFromStdin) {
  in_.str(R"({"name": "piped", "features": []})");
  ASSERT_EQ(run({"mesh", "-", "-o", file("m.vtu")}), kFine) << err_.str();
  EXPECT_EQ(service_.requests[0].create().model().name(), "piped");
}

TEST_F(Cli, ReadsAnEditOrABaseFromStdinButNotBoth) {
  in_.str(R"({"edits": [{"removeFeature": {"feature": "rib"}}]})");
  ASSERT_EQ(run({"edit", "simple", "-", "-o", file("m.vtu")}), kFine) << err_.str();
  EXPECT_EQ(service_.requests[0].edit().edit().edits(0).remove_feature().feature(), "rib");
  in_.clear();
  in_.str(R"({"name": "piped", "features": []})");
  ASSERT_EQ(run({"edit", "-", "--set", "wall=8", "-o", file("m.vtu")}), kFine) << err_.str();
  EXPECT_EQ(service_.requests[1].create().model().name(), "piped");
  EXPECT_EQ(run({"edit", "-", "-", "-o", file("m.vtu")}), kUsage);
  EXPECT_EQ(run({"diff", "-", "-"}), kUsage);
}

TEST_F(Cli, CallsStdinSoInErrors) {
  in_.str("{\"features\": [\n  {\"id\": }]}");
  EXPECT_EQ(run({"validate", "-"}), kInvalid);
  EXPECT_THAT(err_.str(), StartsWith("remesh: <stdin>:2:10: "));
  auto error = client::make_error(remesh::v1::Error::CODE_INVALID_ARGUMENT,
                                  remesh::v1::Error::DEGENERATE_FEATURE);
  error.set_stage("model");
  error.add_features("plate");
  error.set_parameter("dy");
  service_.stream_errors[0] = error;
  in_.clear();
  in_.str(R"({"features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
    "parameters": {"dx": 80, "dy": 0}}]})");
  EXPECT_EQ(run({"mesh", "-", "-o", file("m.vtu")}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("<stdin>:2:36: feature plate, parameter dy"));
}

TEST_F(Cli, WritesAMeshToStdoutAndWhatPeopleReadToStderr) {
  ASSERT_EQ(run({"mesh", kModel, "-o", "-", "--format", "msh"}), kFine) << err_.str();
  EXPECT_EQ(out_.str(), client::to_msh(service_.mesh));
  EXPECT_THAT(err_.str(), HasSubstr("edge length "));
  ASSERT_EQ(run({"get", "simple", "-o", "-", "--format", "inp"}), kFine) << err_.str();
  EXPECT_EQ(out_.str(), client::to_inp(service_.mesh));
  ASSERT_EQ(run({"-q", "mesh", kModel, "-o", "-", "--format", "vtu"}), kFine) << err_.str();
  EXPECT_EQ(err_.str(), "");
}

TEST_F(Cli, TakesAFormatBeforeAnEnding) {
  ASSERT_EQ(run({"mesh", kModel, "-o", file("mesh.dat"), "-o", file("b.vtu"), "--format", "inp"}),
            kFine)
      << err_.str();
  for (const char* name : {"mesh.dat", "b.vtu"}) {
    std::ifstream in(folder_ / name);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), client::to_inp(service_.mesh));
  }
}

TEST_F(Cli, RefusesOutputsThatAreNotClear) {
  EXPECT_EQ(run({"mesh", kModel, "-o", "-"}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("--format"));
  EXPECT_EQ(run({"mesh", kModel, "-o", "-", "-o", "-", "--format", "vtu"}), kUsage);
  EXPECT_EQ(run({"mesh", kModel, "-o", "-", "--json", "-", "--format", "vtu"}), kUsage);
  EXPECT_EQ(run({"mesh", kModel, "-o", file("m.vtu"), "--format", "stl"}), kUsage);
  EXPECT_THAT(service_.requests, SizeIs(0));
}

TEST_F(Cli, TheFileOfAFaultThatHasNoPlaceInItIsTold) {
  auto error = client::make_error(remesh::v1::Error::CODE_INVALID_ARGUMENT,
                                  remesh::v1::Error::DEGENERATE_FEATURE);
  error.set_stage("model");
  service_.stream_errors[0] = error;
  EXPECT_EQ(run({"mesh", kModel, "-o", file("m.vtu")}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("remesh: " + kModel + ": "));
}

}  // namespace
}  // namespace remeshd::cli
