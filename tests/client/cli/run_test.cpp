#include "client/cli/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "client/cli/exit_code.h"
#include "client/formats/read_mesh.h"
#include "tests/client/fake_service.h"
#include "tests/client/temporary_folder.h"

namespace remeshd::cli {
namespace {

using client::make_error;
using remesh::v1::Error;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

const std::string kCases = REMESHD_CASES_DIR;

class Cli : public testing::Test {
 protected:
  int run(const std::vector<std::string>& arguments) {
    out_.str("");
    err_.str("");
    return cli::run(arguments, {.out = out_,
                                .err = err_,
                                .terminal = false,
                                .stop = stop_.get_token(),
                                .connect = [this](const GlobalOptions& options) {
                                  seen_ = options;
                                  return client::Client::connect(daemon_.address);
                                }});
  }

  [[nodiscard]] nlohmann::json read_json(const std::string& name) const {
    return nlohmann::json::parse(std::ifstream(folder_ / name));
  }
  std::string file(const std::string& name) { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::vector<std::string>> rows() const {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(out_.str());
    std::string line;
    while (std::getline(text, line)) {
      auto& row = rows.emplace_back();
      std::istringstream cells(line + "\t");
      std::string cell;
      while (std::getline(cells, cell, '\t')) row.push_back(cell);
    }
    return rows;
  }

  TemporaryFolder folder_;
  client::FakeDaemon daemon_;
  client::FakeService& service_ = daemon_.service;
  GlobalOptions seen_;
  std::stop_source stop_;
  std::ostringstream out_, err_;
};

TEST_F(Cli, MeshSendsTheOptionsGivenAndWritesMeshAndReport) {
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "--nodes", "1500", "--iterations", "5",
                 "--seed", "7", "--threads", "2", "--design", "dd", "--keep-head", "-o",
                 file("m.vtu"), "--json", file("r.json")}),
            kFine)
      << err_.str();
  ASSERT_THAT(service_.requests, SizeIs(1));
  const auto& request = service_.requests[0].create();
  EXPECT_EQ(request.model().name(), "simple-a");
  EXPECT_EQ(request.options().nodes(), 1500U);
  EXPECT_EQ(request.options().iterations(), 5U);
  EXPECT_EQ(request.options().seed(), 7U);
  EXPECT_EQ(request.threads(), 2U);
  EXPECT_EQ(request.design(), "dd");
  EXPECT_TRUE(request.head().has_advance());
  EXPECT_FALSE(request.head().advance());
  EXPECT_EQ(client::read_mesh(folder_ / "m.vtu").tets, service_.mesh.tets);
  const auto report = read_json("r.json");
  EXPECT_EQ(report["revision"], "rev-1");
  EXPECT_EQ(report["nodes"], 1500);
  EXPECT_TRUE(report["nodes_kept"].is_number_unsigned());
  EXPECT_EQ(report["nodes_kept"], 0);
  EXPECT_EQ(report["volume"], 0.1);
  EXPECT_EQ(report["cached"], false);
  EXPECT_EQ(report["warnings"], nlohmann::json::array());
  EXPECT_EQ(report["seconds"]["total"], 0.5);
  EXPECT_EQ(report["seconds"]["setup"], 0.0);
  EXPECT_EQ(report["quality"]["dihedral_min"], 25.0);
}

TEST_F(Cli, OptionsThatAreNotGivenStayUnsetSoThatTheDaemonDecides) {
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.msh")}), kFine) << err_.str();
  EXPECT_EQ(service_.requests[0].create().options().ByteSizeLong(), 0U);
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.msh"), "--iterations", "auto"}),
            kFine);
  EXPECT_TRUE(service_.requests[1].create().options().has_iterations());
  EXPECT_EQ(service_.requests[1].create().options().iterations(), 0U);
}

TEST_F(Cli, KeepsDataAndMessagesApart) {
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.inp"), "--json", "-"}), kFine);
  EXPECT_EQ(nlohmann::json::parse(out_.str())["revision"], "rev-1");
  EXPECT_EQ(err_.str(), "50 % optimise 3\n");
  ASSERT_EQ(run({"-q", "mesh", kCases + "/simple-a.json", "-o", file("m.inp")}), kFine);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(Cli, TakesGlobalOptionsBeforeAndAfterTheCommand) {
  ASSERT_EQ(run({"--address", "host:1", "revisions"}), kFine) << err_.str();
  EXPECT_EQ(seen_.address, "host:1");
  ASSERT_EQ(run({"revisions", "--address", "host:2"}), kFine) << err_.str();
  EXPECT_EQ(seen_.address, "host:2");
  ASSERT_EQ(run({"revisions", "--local", "--store", "/tmp/x"}), kFine) << err_.str();
  EXPECT_TRUE(seen_.local);
  EXPECT_EQ(seen_.store, "/tmp/x");
  ASSERT_EQ(run({"--local", "log", "d", "--store", "/tmp/y"}), kFine) << err_.str();
  EXPECT_EQ(seen_.store, "/tmp/y");
}

TEST_F(Cli, TakesTheAddressFromTheEnvironment) {
  ::setenv("REMESH_ADDRESS", "elsewhere:5", 1);
  EXPECT_EQ(run({"revisions"}), kFine);
  ::unsetenv("REMESH_ADDRESS");
  EXPECT_EQ(seen_.address, "elsewhere:5");
  EXPECT_EQ(run({"revisions"}), kFine);
  EXPECT_EQ(seen_.address, "127.0.0.1:50051");
}

TEST_F(Cli, EditOfARevisionSendsItsNameAndOnlyTheOptionsGiven) {
  ASSERT_EQ(run({"edit", "simple@3", kCases + "/simple-ab.edit.json", "-o", file("m.vtu"), "--size",
                 "2.5"}),
            kFine)
      << err_.str();
  ASSERT_THAT(service_.requests, SizeIs(1));
  const auto& edit = service_.requests[0].edit();
  EXPECT_EQ(edit.base(), "simple@3");
  EXPECT_EQ(edit.edit().edits(0).set_parameter().name(), "top_x");
  EXPECT_EQ(edit.options().size(), 2.5);
  EXPECT_FALSE(edit.options().has_iterations());
}

TEST_F(Cli, EditOfAModelFileMeshesItFirstAndInheritsItsOptions) {
  ASSERT_EQ(run({"edit", kCases + "/simple-a.json", kCases + "/simple-ab.edit.json", "-o",
                 file("m.vtu"), "--nodes", "900", "--json", file("r.json")}),
            kFine)
      << err_.str();
  ASSERT_THAT(service_.requests, SizeIs(2));
  EXPECT_EQ(service_.requests[0].create().options().nodes(), 900U);
  EXPECT_EQ(service_.requests[1].edit().base(), "rev-1");
  EXPECT_EQ(service_.requests[1].edit().options().ByteSizeLong(), 0U);
  EXPECT_EQ(read_json("r.json")["revision"], "rev-2");
  EXPECT_EQ(read_json("r.json")["nodes_kept"], 1200);
}

TEST_F(Cli, AnExistingFileComesBeforeARevisionOfThatName) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  std::filesystem::copy(kCases + "/simple-a.json", "simple");
  const int code = run({"edit", "simple", kCases + "/simple-ab.edit.json", "-o", file("m.vtu")});
  std::filesystem::remove("simple");
  std::filesystem::create_directory("simple");  // a folder is no model
  const int code_of_revision =
      run({"edit", "simple", kCases + "/simple-ab.edit.json", "-o", file("m.vtu")});
  std::filesystem::current_path(before);
  EXPECT_EQ(code, kFine);
  EXPECT_EQ(code_of_revision, kFine);
  ASSERT_THAT(service_.requests, SizeIs(3));
  EXPECT_TRUE(service_.requests[0].has_create());
  EXPECT_EQ(service_.requests[1].edit().base(), "rev-1");
  EXPECT_EQ(service_.requests[2].edit().base(), "simple");
}

TEST_F(Cli, SaysThatTheHeadStayedWhereAnotherEditMovedIt) {
  service_.head_moved = true;
  ASSERT_EQ(run({"edit", "simple", kCases + "/simple-ab.edit.json", "-o", file("m.vtu")}), kFine);
  EXPECT_THAT(err_.str(), HasSubstr("the head of d stays at 9"));
}

TEST_F(Cli, SweepSendsEachStepOnTheLastOneAndPrintsARowForIt) {
  ASSERT_EQ(run({"sweep", "simple", "top_x", "-5", "5", "3", "-o", file("steps")}), kFine)
      << err_.str();
  ASSERT_THAT(service_.requests, SizeIs(3));
  const std::vector<std::string> bases{"id-of-simple", "rev-1", "rev-2"};
  const std::vector<double> values{-5, 0, 5};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& edit = service_.requests[k].edit();
    EXPECT_EQ(edit.base(), bases[k]);
    EXPECT_EQ(edit.edit().edits(0).set_parameter().name(), "top_x");
    EXPECT_EQ(edit.edit().edits(0).set_parameter().value().number_value(), values[k]);
    EXPECT_TRUE(
        std::filesystem::exists(folder_ / "steps" / ("step-" + std::to_string(k + 1) + ".vtu")));
  }
  const auto table = rows();
  ASSERT_THAT(table, SizeIs(4));
  EXPECT_THAT(table[0], SizeIs(17));
  EXPECT_EQ(table[3][1], "5");
  EXPECT_EQ(table[3][2], "ok");
  EXPECT_EQ(table[3][3], "rev-3");
  EXPECT_EQ(table[3][6], "1200");
}

TEST_F(Cli, SweepGoesOnPastAFailedStepFromTheLastGoodOneAndThenExits4) {
  service_.stream_errors[1] = make_error(Error::INVALID_ARGUMENT, "DegenerateFeature");
  EXPECT_EQ(run({"sweep", "simple", "hub.radius", "1", "3", "3"}), kFailed);
  ASSERT_THAT(service_.requests, SizeIs(3));
  EXPECT_EQ(service_.requests[2].edit().base(), "rev-1");
  EXPECT_EQ(service_.requests[2].edit().edit().edits(0).set_feature_parameter().feature(), "hub");
  EXPECT_EQ(service_.requests[2].edit().edit().edits(0).set_feature_parameter().name(), "radius");
  const auto table = rows();
  ASSERT_THAT(table, SizeIs(4));
  EXPECT_EQ(table[2][2], "DegenerateFeature");
  EXPECT_THAT(table[2], SizeIs(17));
  EXPECT_EQ(table[2][16], "told by the test");
  EXPECT_EQ(table[3][2], "ok");
  EXPECT_THAT(err_.str(), HasSubstr("step 2: told by the test"));
}

TEST_F(Cli, SweepFromBaseEditsTheBaseInEveryStep) {
  ASSERT_EQ(run({"sweep", "simple", "top_x", "1", "2", "2", "--from-base"}), kFine);
  EXPECT_EQ(service_.requests[1].edit().base(), "id-of-simple");
}

TEST_F(Cli, SweepOfAParameterThatIsNotThereExits3BeforeTheFirstStep) {
  EXPECT_EQ(run({"sweep", "simple", "no_such", "1", "2", "2"}), kInvalid);
  EXPECT_EQ(run({"sweep", "simple", "rib.radius", "1", "2", "2"}), kInvalid);
  EXPECT_EQ(run({"sweep", kCases + "/simple-a.json", "no_such", "1", "2", "2"}), kInvalid);
  EXPECT_EQ(out_.str(), "");
  EXPECT_THAT(service_.requests, SizeIs(0));
}

TEST_F(Cli, SweepEndsWhereTheDaemonIsGone) {
  service_.stream_failure = make_error(Error::UNAVAILABLE, "ShuttingDown");
  EXPECT_EQ(run({"sweep", "simple", "top_x", "1", "2", "2"}), kUnreachable);
}

TEST_F(Cli, DiffSendsRevisionsModelsAndEditsAndWritesClassesAsNumbers) {
  auto* feature = service_.comparison.add_features();
  feature->set_id("rib");
  (*feature->mutable_cells())["++"] = 10000;
  (*feature->mutable_cells())[".+"] = 6000;
  (*feature->mutable_faces())["bn"] = 0.5;
  service_.comparison.set_copycells(1);
  service_.comparison.set_method("test");
  ASSERT_EQ(run({"diff", kCases + "/fig11-a.json", kCases + "/fig11-ab.edit.json", "--json",
                 file("d.json")}),
            kFine)
      << err_.str();
  EXPECT_EQ(service_.compare_request.original().model().name(), "fig11-a");
  EXPECT_EQ(service_.compare_request.modified().edit().edits_size(), 3);
  const auto json = read_json("d.json");
  EXPECT_EQ(json["features"][0]["id"], "rib");
  EXPECT_EQ(json["features"][0]["cells"], (nlohmann::json{{"++", 10000.0}, {".+", 6000.0}}));
  EXPECT_EQ(json["features"][0]["faces"], (nlohmann::json{{"bn", 0.5}}));
  EXPECT_EQ(json["copycells"], 1.0);
  EXPECT_EQ(json["newcells"], 0.0);
  EXPECT_EQ(json["method"], "test");
  EXPECT_EQ(json["error_bound"], 0.0);
  EXPECT_THAT(out_.str(), HasSubstr("rib      cells  ++"));

  ASSERT_EQ(run({"diff", "a@1", "a@2"}), kFine) << err_.str();
  EXPECT_EQ(service_.compare_request.original().revision(), "a@1");
  EXPECT_EQ(service_.compare_request.modified().revision(), "a@2");
  EXPECT_EQ(run({"diff", kCases + "/fig11-ab.edit.json", "a@2"}), kUsage);
}

TEST_F(Cli, ValidateTakesAModelOrAnEditWithItsBase) {
  ASSERT_EQ(run({"validate", kCases + "/simple-a.json"}), kFine);
  EXPECT_EQ(service_.model_request.model().name(), "simple-a");
  EXPECT_THAT(out_.str(), HasSubstr("258000"));
  ASSERT_EQ(run({"validate", kCases + "/simple-ab.edit.json", "--base", "simple"}), kFine);
  EXPECT_EQ(service_.edit_request.base(), "simple");
  ASSERT_EQ(run({"validate", kCases + "/simple-ab.edit.json", "--base", kCases + "/simple-a.json"}),
            kFine);
  EXPECT_EQ(service_.edit_request.model().name(), "simple-a");
  EXPECT_EQ(run({"validate", kCases + "/simple-ab.edit.json"}), kFine);
  EXPECT_EQ(run({"validate", "simple"}), kInvalid);
  EXPECT_EQ(run({"validate", kCases + "/simple-a.json", "--base", "simple"}), kUsage);
}

TEST_F(Cli, ListsModelsAndDeletesRevisions) {
  for (int k = 1; k <= 2; ++k) {
    auto& revision = service_.revisions.emplace_back();
    revision.set_id(std::string(64, static_cast<char>('a' + k)));
    revision.set_design(k == 1 ? "one" : "two");
    revision.set_number(static_cast<std::uint32_t>(k));
    revision.set_head(true);
  }
  ASSERT_EQ(run({"revisions"}), kFine);
  EXPECT_THAT(out_.str(), AllOf(HasSubstr("one@1     bbbbbbbbbbbb"), HasSubstr("two@2")));
  ASSERT_EQ(run({"log", "two", "--json", file("l.json")}), kFine);
  EXPECT_EQ(read_json("l.json")["revisions"].size(), 1U);
  ASSERT_EQ(run({"model", "one@1", "-o", file("m.json")}), kFine);
  EXPECT_EQ(read_json("m.json")["name"], "described");
  ASSERT_EQ(run({"rm", "one@1", "two@2", "--allow-head"}), kFine);
  ASSERT_THAT(service_.deletions, SizeIs(2));
  EXPECT_EQ(service_.deletions[1].revision(), "two@2");
  EXPECT_TRUE(service_.deletions[1].allow_head());
  ASSERT_EQ(run({"get", "one", "-o", file("g.inp")}), kFine);
  EXPECT_EQ(client::read_mesh(folder_ / "g.inp").nodes.size(), service_.mesh.nodes.size());
  ASSERT_EQ(run({"types"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("sphere  radius"));
}

TEST_F(Cli, WrongUsageExits2AndAsksNothingOfTheDaemon) {
  const std::string model = kCases + "/simple-a.json";
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"no-such-command"},
      {"mesh", model},
      {"mesh", model, "-o", file("m.stl")},
      {"mesh", model, "-o", file("nowhere/m.vtu")},
      {"mesh", model, "-o", file("m.vtu"), "--json", file("nowhere/r.json")},
      {"mesh", model, "-o", file("m.vtu"), "--nodes", "10", "--size", "1"},
      {"mesh", model, "-o", file("m.vtu"), "--nodes", "19"},
      {"mesh", model, "-o", file("m.vtu"), "--nodes", "1.5"},
      {"mesh", model, "-o", file("m.vtu"), "--size", "-1"},
      {"mesh", model, "-o", file("m.vtu"), "--size", "nan"},
      {"mesh", model, "-o", file("m.vtu"), "--iterations", "0"},
      {"mesh", model, "-o", file("m.vtu"), "--iterations", "some"},
      {"mesh", model, "-o", file("m.vtu"), "--seed", "-1"},
      {"mesh", model, "-o", file("m.vtu"), "--threads", "0"},
      {"mesh", model, "-o", file("m.vtu"), "--frobnicate"},
      {"sweep", "simple", "x", "0", "1", "0"},
      {"sweep", "simple", "x", "0", "inf", "3"},
      {"edit", kCases + "/simple-ab.edit.json", kCases + "/simple-ab.edit.json", "-o",
       file("m.vtu")},
      {"revisions", "--store", "/tmp/x"},
      {"-q", "-v", "revisions"},
      {"log"}};
  for (const auto& arguments : wrong) {
    EXPECT_EQ(run(arguments), kUsage) << testing::PrintToString(arguments);
    EXPECT_EQ(out_.str(), "");
    EXPECT_NE(err_.str(), "");
  }
  EXPECT_THAT(service_.requests, SizeIs(0));
}

TEST_F(Cli, HelpIsDataAndTellsTheExitCodes) {
  EXPECT_EQ(run({"--help"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("130 interrupted"));
  EXPECT_EQ(run({"sweep", "--help"}), kFine);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(Cli, UnreadableAndOversizedAndWrongDocumentsExit3) {
  const std::string out = file("m.vtu");
  std::ofstream(folder_ / "trailing.json") << R"({"name": "x", "features": [],})";
  std::ofstream(folder_ / "deep.json") << std::string(100'000, '[');
  std::ofstream(folder_ / "big.json") << std::string((std::size_t{4} << 20) + 1, ' ');
  for (const char* name : {"absent.json", "trailing.json", "deep.json", "big.json"}) {
    EXPECT_EQ(run({"mesh", file(name), "-o", out}), kInvalid) << name;
    EXPECT_EQ(run({"edit", file(name), kCases + "/simple-ab.edit.json", "-o", out}), kInvalid)
        << name;
    EXPECT_EQ(run({"edit", "simple", file(name), "-o", out}), kInvalid) << name;
  }
  EXPECT_EQ(run({"mesh", kCases + "/simple-ab.edit.json", "-o", out}), kInvalid);
  EXPECT_THAT(service_.requests, SizeIs(0));
  EXPECT_EQ(run({"quality", file("absent.vtu")}), kInvalid);
}

struct Failure {
  Error::Code code;
  const char* reason;
  int exit;
};

class CliFailure : public Cli, public testing::WithParamInterface<Failure> {};

TEST_P(CliFailure, OfTheStreamAndOfACallHasItsExitCode) {
  const auto error = make_error(GetParam().code, GetParam().reason);
  service_.stream_errors[0] = error;
  EXPECT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu")}), GetParam().exit);
  EXPECT_THAT(err_.str(), HasSubstr("told by the test"));
  EXPECT_EQ(out_.str(), "");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.vtu"));
  service_.failure = error;
  EXPECT_EQ(run({"diff", "a", "b"}), GetParam().exit);
  EXPECT_EQ(run({"get", "a", "-o", file("m.vtu")}), GetParam().exit);
}

INSTANTIATE_TEST_SUITE_P(
    All, CliFailure,
    testing::Values(Failure{Error::INVALID_ARGUMENT, "DegenerateFeature", 3},
                    Failure{Error::NOT_FOUND, "NoSuchRevision", 3},
                    Failure{Error::FAILED_PRECONDITION, "BoundaryNotRecovered", 4},
                    Failure{Error::FAILED_PRECONDITION, "EmptyModel", 3},
                    Failure{Error::FAILED_PRECONDITION, "DisconnectedModel", 3},
                    Failure{Error::RESOURCE_EXHAUSTED, "DocumentTooLarge", 3},
                    Failure{Error::DEADLINE_EXCEEDED, "TooSlow", 4},
                    Failure{Error::INTERNAL, "Internal", 4},
                    Failure{Error::UNAVAILABLE, "ShuttingDown", 5},
                    Failure{Error::RESOURCE_EXHAUSTED, "Busy", 6},
                    Failure{Error::ABORTED, "HeadMoved", 6},
                    Failure{Error::PERMISSION_DENIED, "Denied", 7},
                    Failure{Error::UNAUTHENTICATED, "NoCertificate", 7}),
    [](const auto& failure) {
      return Error::Code_Name(failure.param.code) + "_" + failure.param.reason;
    });

TEST_F(Cli, AnInterruptCancelsTheCallAndExits130) {
  service_.hanging = {0};
  std::thread interrupter([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop_.request_stop();
  });
  EXPECT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu")}), kInterrupted);
  interrupter.join();
  EXPECT_EQ(run({"revisions"}), kInterrupted);
}

TEST_F(Cli, QualityMeasuresARegularTetExactly) {
  std::ofstream(folder_ / "t.inp")
      << "*NODE\n1, 1, 1, 1\n2, 1, -1, -1\n3, -1, -1, 1\n4, -1, 1, -1\n"
         "*ELEMENT, TYPE=C3D4, ELSET=All\n1, 1, 2, 4, 3\n";
  ASSERT_EQ(run({"quality", file("t.inp"), "--exact-volume", "2"}), kFine) << err_.str();
  const auto json = nlohmann::json::parse(out_.str());
  EXPECT_EQ(json["nodes"], 4);
  EXPECT_EQ(json["bfaces"], 4);
  EXPECT_EQ(json["neg"], 0);
  EXPECT_NEAR(json["vl_min"], 1, 1e-15);
  EXPECT_NEAR(json["dih_max"], 70.528779365509, 1e-10);
  EXPECT_NEAR(json["volume"], 8.0 / 3, 1e-15);
  EXPECT_NEAR(json["vol_err"], 1.0 / 3, 1e-15);
  EXPECT_NEAR(json["edge_mean"], std::sqrt(8), 1e-15);
}

}  // namespace
}  // namespace remeshd::cli
