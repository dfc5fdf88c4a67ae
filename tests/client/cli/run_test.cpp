#include "client/cli/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "client/formats/read_mesh.h"
#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using client::make_error;
using remesh::v1::Error;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

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
  EXPECT_EQ(report["way"], "WAY_LOCAL");
  EXPECT_EQ(report["warnings"], nlohmann::json::array());
  EXPECT_EQ(report["attempts"], nlohmann::json::array());
  EXPECT_EQ(report["last_resort_share"], 0.0);
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

TEST_F(Cli, MeshSendsTheOrderThatIsGiven) {
  const std::vector<std::string> mesh{"mesh", kCases + "/simple-a.json", "-o", file("m.msh")};
  const auto with_order = [&](const std::string& order) {
    std::vector<std::string> arguments = mesh;
    arguments.insert(arguments.end(), {"--order", order});
    return arguments;
  };
  ASSERT_EQ(run(with_order("2")), kFine) << err_.str();
  EXPECT_EQ(service_.requests[0].create().options().order(), 2U);
  for (const char* wrong : {"0", "3", "two"}) EXPECT_EQ(run(with_order(wrong)), kUsage) << wrong;
}

TEST_F(Cli, MeshSendsTheRulesOfASizeFieldThatAreGiven) {
  const std::vector<std::string> mesh{"mesh", kCases + "/simple-a.json", "-o", file("m.msh")};
  const auto sent = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> arguments = mesh;
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    EXPECT_EQ(run(arguments), kFine) << err_.str();
    return service_.requests.back().create().options().sizing();
  };
  const auto rules =
      sent({"--edges-per-circle", "20", "--layers", "0", "--min-size", "0.25", "--growth", "1.5"});
  EXPECT_EQ(rules.edges_per_circle(), 20U);
  EXPECT_TRUE(rules.has_layers());
  EXPECT_EQ(rules.layers(), 0U);
  EXPECT_EQ(rules.min_size(), 0.25);
  EXPECT_EQ(rules.growth(), 1.5);
  EXPECT_FALSE(rules.has_even());
  const auto even = sent({"--even"});
  EXPECT_TRUE(even.even());
  EXPECT_FALSE(even.has_growth());
  const auto one = sent({"--growth", "2"});
  EXPECT_EQ(one.ByteSizeLong(), 9U) << "nothing else is set";
}

TEST_F(Cli, KeepsDataAndMessagesApart) {
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.inp"), "--json", "-"}), kFine);
  EXPECT_EQ(nlohmann::json::parse(out_.str())["revision"], "rev-1");
  EXPECT_EQ(err_.str(), "") << "progress is for terminals";
  ASSERT_EQ(run({"-v", "mesh", kCases + "/simple-a.json", "-o", file("m.inp")}), kFine);
  EXPECT_THAT(err_.str(), HasSubstr("50 % optimise 3\n"));
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

TEST_F(Cli, TheAddressLocalMeansNoDaemon) {
  ::setenv("REMESH_ADDRESS", "local", 1);
  EXPECT_EQ(run({"revisions", "--store", "/tmp/x"}), kFine) << err_.str();
  EXPECT_TRUE(seen_.local);
  EXPECT_EQ(run({"revisions", "--address", "host:3"}), kFine);
  EXPECT_FALSE(seen_.local);
  ::unsetenv("REMESH_ADDRESS");
}

TEST_F(Cli, MeshWritesEveryFileThatIsNamed) {
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu"), "-o", file("m.inp")}),
            kFine)
      << err_.str();
  for (const char* name : {"m.vtu", "m.inp"})
    EXPECT_EQ(client::read_mesh(folder_ / name).tets, service_.mesh.tets) << name;
  EXPECT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu"), "-o", file("m.pdf")}),
            kUsage);
}

TEST_F(Cli, TheSummarySaysWhichWayAMeshCameAboutAndHowFine) {
  ASSERT_EQ(run({"mesh", kCases + "/simple-a.json", "-o", file("m.vtu")}), kFine) << err_.str();
  for (const char* row : {"way ", "local", "edge length ", "chord error "})
    EXPECT_THAT(out_.str(), HasSubstr(row));
}

TEST_F(Cli, TakesTheAddressFromTheEnvironment) {
  ::setenv("REMESH_ADDRESS", "elsewhere:5", 1);
  EXPECT_EQ(run({"revisions"}), kFine);
  ::unsetenv("REMESH_ADDRESS");
  EXPECT_EQ(seen_.address, "elsewhere:5");
  EXPECT_EQ(run({"revisions"}), kFine);
  EXPECT_EQ(seen_.address, "127.0.0.1:50051");
}

TEST_F(Cli, TakesTheFilesOfTlsAndOfTheTokenFromOptionsBeforeTheEnvironment) {
  ::setenv("REMESH_TLS_CA", "ca-of-all", 1);
  ::setenv("REMESH_TOKEN_FILE", "token-of-all", 1);
  EXPECT_EQ(
      run({"revisions", "--tls-cert", "my.pem", "--tls-key", "my.key", "--token-file", "mine"}),
      kFine)
      << err_.str();
  ::unsetenv("REMESH_TLS_CA");
  ::unsetenv("REMESH_TOKEN_FILE");
  EXPECT_EQ(seen_.tls_ca, "ca-of-all");
  EXPECT_EQ(seen_.tls_cert, "my.pem");
  EXPECT_EQ(seen_.tls_key, "my.key");
  EXPECT_EQ(seen_.token_file, "mine");
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
  EXPECT_EQ(service_.requests[1].edit().design(), "simple-a") << "the base may be in others too";
  EXPECT_EQ(service_.requests[1].edit().options().ByteSizeLong(), 0U);
  EXPECT_EQ(read_json("r.json")["revision"], "rev-2");
  EXPECT_EQ(read_json("r.json")["nodes_kept"], 1200);
}

TEST_F(Cli, ABaseIsAFileOnlyByItsName) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  for (const char* name : {"simple", "simple.json"})
    std::filesystem::copy(kCases + "/simple-a.json", name);
  const std::string edit = kCases + "/simple-ab.edit.json";
  for (const char* base : {"simple", "simple.json", "./simple"})
    EXPECT_EQ(run({"edit", base, edit, "-o", file("m.vtu")}), kFine) << base;
  EXPECT_EQ(run({"validate", "simple"}), kFine) << "a document may have any name";
  std::filesystem::current_path(before);
  ASSERT_THAT(service_.requests, SizeIs(5));
  EXPECT_EQ(service_.requests[0].edit().base(), "simple");
  EXPECT_TRUE(service_.requests[1].has_create());
  EXPECT_TRUE(service_.requests[3].has_create());
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
    EXPECT_TRUE(edit.head().has_advance() && !edit.head().advance());
    EXPECT_TRUE(edit.head().has_file() && !edit.head().file());
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

TEST_F(Cli, SweepMovesNoHeadWhereTheDaemonFilesAllRevisions) {
  service_.files_all = true;
  ASSERT_EQ(run({"sweep", "simple", "top_x", "-5", "5", "3"}), kFine) << err_.str();
  ASSERT_THAT(service_.requests, SizeIs(4)) << "the first step is sent again";
  for (std::size_t k = 1; k < 4; ++k) {
    const auto& head = service_.requests[k].edit().head();
    EXPECT_TRUE(head.has_advance() && !head.advance());
    EXPECT_FALSE(head.has_file());
  }
  EXPECT_THAT(rows(), SizeIs(4));
}

TEST_F(Cli, EditTakesItsChangesFromTheCommandLine) {
  ASSERT_EQ(run({"edit", "simple", "--set", "wall=8", "--remove", "rib", "--set",
                 "hole.radius=9.5e-1", "--set", "depth=wall / 2", "-o", file("m.vtu")}),
            kFine)
      << err_.str();
  const auto& edits = service_.requests[0].edit().edit().edits();
  ASSERT_EQ(edits.size(), 4);
  EXPECT_EQ(edits[0].set_parameter().name(), "wall");
  EXPECT_EQ(edits[0].set_parameter().value().number_value(), 8);
  EXPECT_EQ(edits[1].set_feature_parameter().feature(), "hole");
  EXPECT_EQ(edits[1].set_feature_parameter().name(), "radius");
  EXPECT_EQ(edits[1].set_feature_parameter().value().number_value(), 0.95);
  EXPECT_EQ(edits[2].set_parameter().value().string_value(), "wall / 2");
  EXPECT_EQ(edits[3].remove_feature().feature(), "rib");
}

TEST_F(Cli, EditAppliesItsDocumentBeforeTheChangesOfTheCommandLine) {
  ASSERT_EQ(run({"edit", "simple", kCases + "/simple-ab.edit.json", "--set", "wall=8", "-o",
                 file("m.vtu")}),
            kFine)
      << err_.str();
  const auto& edits = service_.requests[0].edit().edit().edits();
  ASSERT_GE(edits.size(), 2);
  EXPECT_NE(edits[0].set_parameter().name(), "wall");
  EXPECT_EQ(edits[edits.size() - 1].set_parameter().name(), "wall");
}

TEST_F(Cli, EditWithoutAChangeOrWithHalfOfOneIsAUsageError) {
  EXPECT_EQ(run({"edit", "simple", "-o", file("m.vtu")}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("EDIT.json, --set or --remove"));
  for (const char* wrong : {"wall", "=8", "wall="}) {
    EXPECT_EQ(run({"edit", "simple", "--set", wrong, "-o", file("m.vtu")}), kUsage) << wrong;
    EXPECT_THAT(err_.str(), HasSubstr(std::string("--set ") + wrong));
  }
  EXPECT_THAT(service_.requests, SizeIs(0));
}

TEST_F(Cli, SweepFilesItsRevisionsInTheDesignThatIsNamed) {
  ASSERT_EQ(run({"sweep", kCases + "/simple-a.json", "top_x", "1", "2", "1", "--design", "dd"}),
            kFine);
  ASSERT_THAT(service_.requests, SizeIs(2));
  EXPECT_FALSE(service_.requests[0].create().head().advance());
  EXPECT_TRUE(service_.requests[0].create().head().has_advance());
  EXPECT_EQ(service_.requests[1].edit().design(), "dd");
  EXPECT_FALSE(service_.requests[1].edit().head().has_file());
}

TEST_F(Cli, SweepGoesOnPastAFailedStepFromTheLastGoodOneAndThenExits4) {
  service_.stream_errors[1] = make_error(Error::CODE_INVALID_ARGUMENT, Error::DEGENERATE_FEATURE);
  EXPECT_EQ(run({"sweep", "simple", "hub.radius", "1", "3", "3"}), kFailed);
  ASSERT_THAT(service_.requests, SizeIs(3));
  EXPECT_EQ(service_.requests[2].edit().base(), "rev-1");
  EXPECT_EQ(service_.requests[2].edit().edit().edits(0).set_feature_parameter().feature(), "hub");
  EXPECT_EQ(service_.requests[2].edit().edit().edits(0).set_feature_parameter().name(), "radius");
  const auto table = rows();
  ASSERT_THAT(table, SizeIs(4));
  EXPECT_EQ(table[2][2], "DEGENERATE_FEATURE");
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
  service_.stream_failure = make_error(Error::CODE_UNAVAILABLE, Error::SHUTTING_DOWN);
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
  EXPECT_THAT(out_.str(), HasSubstr("changes  same model"));
  ASSERT_EQ(run({"diff", kCases + "/tool1-a.json", kCases + "/tool1-b.json"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr(" -> "));
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
  EXPECT_EQ(service_.edit_request.base_model().name(), "simple-a");
  EXPECT_EQ(run({"validate", kCases + "/simple-ab.edit.json"}), kFine);
}

TEST_F(Cli, ValidateWithABaseTakesAnyFileForAnEdit) {
  std::ofstream(folder_ / "empty.json") << "{}";
  for (const std::string& name : {file("empty.json"), kCases + "/simple-a.json"}) {
    EXPECT_EQ(run({"validate", name, "--base", "simple"}), kInvalid) << name;
    EXPECT_THAT(err_.str(), HasSubstr("the field 'edits' is missing"));
  }
  EXPECT_EQ(run({"validate", file("empty.json")}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("the field 'features' is missing"));
}

TEST_F(Cli, ValidateTellsWhatMeshingWouldComeTo) {
  ASSERT_EQ(run({"validate", kCases + "/simple-a.json", "--nodes", "300", "--layers", "2",
                 "--fail-on", "DETAIL_NOT_RESOLVED"}),
            kFine);
  const auto& options = service_.model_request.options();
  EXPECT_EQ(options.nodes(), 300U);
  EXPECT_EQ(options.sizing().layers(), 2U);
  EXPECT_THAT(options.fail_on(), testing::ElementsAre(remesh::v1::Warning::DETAIL_NOT_RESOLVED));
  EXPECT_THAT(out_.str(), HasSubstr("15020"));
  EXPECT_THAT(out_.str(), HasSubstr("23.4 MB"));
  EXPECT_THAT(out_.str(), HasSubstr("1.5 s"));
  EXPECT_THAT(out_.str(), HasSubstr("hole.wall: 0.25"));
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
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("first mesh")));
  ASSERT_EQ(run({"log", "two", "--changes"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("first mesh"));
  service_.revisions.back().set_parent("parent");
  ASSERT_EQ(run({"log", "two", "--changes"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("same model"));
  ASSERT_EQ(run({"model", "one@1", "-o", file("m.json")}), kFine);
  EXPECT_EQ(read_json("m.json")["name"], "described");
  std::stringstream model;
  model << std::ifstream(folder_ / "m.json").rdbuf();
  EXPECT_THAT(model.str(), HasSubstr(R"("parameters": {"top_x": 1, "a": 1, "b": 1})"));
  ASSERT_EQ(run({"rm", "one@1", "two@2", "--allow-head"}), kFine);
  ASSERT_THAT(service_.deletions, SizeIs(2));
  EXPECT_EQ(service_.deletions[1].revision(), "two@2");
  EXPECT_TRUE(service_.deletions[1].allow_head());
  ASSERT_EQ(run({"get", "one", "-o", file("g.inp")}), kFine);
  EXPECT_EQ(client::read_mesh(folder_ / "g.inp").nodes.size(), service_.mesh.nodes.size());
  ASSERT_EQ(run({"get", "one", "-o", file("h.inp"), "-o", file("h.msh")}), kFine);
  EXPECT_EQ(client::read_mesh(folder_ / "h.msh").nodes.size(), service_.mesh.nodes.size());
  ASSERT_EQ(run({"types"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("sphere  radius"));
}

TEST_F(Cli, HelpIsDataAndTellsTheExitCodes) {
  EXPECT_EQ(run({"--help"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("130 interrupted"));
  EXPECT_EQ(run({"sweep", "--help"}), kFine);
  EXPECT_THAT(out_.str(), HasSubstr("Nodes to aim at [the base's]"));
  EXPECT_EQ(err_.str(), "");
}

}  // namespace
}  // namespace remeshd::cli
