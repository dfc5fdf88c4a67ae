#include "client/cli/exit_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using client::make_error;
using remesh::v1::Error;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

TEST(ErrorOfThisSide, TellsAnEditAndADelayOnlyWhereThereAreAny) {
  const Error plain = to_detail(ErrorInfo{.kind = ErrorKind::Internal, .reason = "INTERNAL"});
  EXPECT_FALSE(plain.has_edit_index());
  EXPECT_FALSE(plain.has_retry_after());
  const Error of_an_edit =
      to_detail(ErrorInfo{.edit_index = 2, .retry_after = 1.5, .attempts = {"full: flat"}});
  EXPECT_EQ(of_an_edit.edit_index(), 2U);
  EXPECT_EQ(of_an_edit.retry_after(), 1.5);
  EXPECT_THAT(of_an_edit.attempts(), testing::ElementsAre("full: flat"));
}

TEST_F(Cli, WrongUsageExits2AndAsksNothingOfTheDaemon) {
  const std::string model = kCases + "/simple-a.json";
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"no-such-command"},
      {"mesh", model},
      {"mesh", model, "-o", file("m.stl")},
      {"mesh", model, "-o", file("m.vtu"), "--nodes", "10", "--size", "1"},
      {"mesh", model, "-o", file("m.vtu"), "--nodes", "19"},
      {"mesh", model, "-o", file("m.vtu"), "--nodes", "1.5"},
      {"mesh", model, "-o", file("m.vtu"), "--size", "-1"},
      {"mesh", model, "-o", file("m.vtu"), "--size", "nan"},
      {"mesh", model, "-o", file("m.vtu"), "--iterations", "0"},
      {"mesh", model, "-o", file("m.vtu"), "--iterations", "some"},
      {"mesh", model, "-o", file("m.vtu"), "--seed", "-1"},
      {"mesh", model, "-o", file("m.vtu"), "--threads", "0"},
      {"mesh", model, "-o", file("m.vtu"), "--edges-per-circle", "2"},
      {"mesh", model, "-o", file("m.vtu"), "--edges-per-circle", "361"},
      {"mesh", model, "-o", file("m.vtu"), "--edges-per-circle", "-3"},
      {"mesh", model, "-o", file("m.vtu"), "--layers", "17"},
      {"mesh", model, "-o", file("m.vtu"), "--layers", "-1"},
      {"mesh", model, "-o", file("m.vtu"), "--min-size", "0"},
      {"mesh", model, "-o", file("m.vtu"), "--growth", "1"},
      {"mesh", model, "-o", file("m.vtu"), "--growth", "2.1"},
      {"mesh", model, "-o", file("m.vtu"), "--even", "--layers", "2"},
      {"mesh", model, "-o", file("m.vtu"), "--frobnicate"},
      {"sweep", "simple", "x", "0", "1", "0"},
      {"sweep", "simple", "x", "0", "inf", "3"},
      {"edit", kCases + "/simple-ab.edit.json", kCases + "/simple-ab.edit.json", "-o",
       file("m.vtu")},
      {"revisions", "--store", "/tmp/x"},
      {"revisions", "--address", "127.0.0.1:1,local"},
      {"revisions", "--address", "local,127.0.0.1:1"},
      {"revisions", "--patience", "-1"},
      {"-q", "-v", "revisions"},
      {"log"}};
  for (const auto& arguments : wrong) {
    EXPECT_EQ(run(arguments), kUsage) << testing::PrintToString(arguments);
    EXPECT_EQ(out_.str(), "");
    EXPECT_NE(err_.str(), "");
  }
  EXPECT_THAT(service_.requests, SizeIs(0));
}

TEST_F(Cli, OversizedAndWrongDocumentsExit3) {
  const std::string out = file("m.vtu");
  std::ofstream(folder_ / "trailing.json") << R"({"name": "x", "features": [],})";
  std::ofstream(folder_ / "deep.json") << std::string(100'000, '[');
  std::ofstream(folder_ / "big.json") << std::string((std::size_t{4} << 20) + 1, ' ');
  for (const char* name : {"trailing.json", "deep.json", "big.json"}) {
    EXPECT_EQ(run({"mesh", file(name), "-o", out}), kInvalid) << name;
    EXPECT_EQ(run({"edit", file(name), kCases + "/simple-ab.edit.json", "-o", out}), kInvalid)
        << name;
    EXPECT_EQ(run({"edit", "simple", file(name), "-o", out}), kInvalid) << name;
  }
  EXPECT_EQ(run({"mesh", kCases + "/simple-ab.edit.json", "-o", out}), kInvalid);
  EXPECT_THAT(service_.requests, SizeIs(0));
  std::ofstream(folder_ / "no-mesh.vtu") << "<VTK";
  EXPECT_EQ(run({"quality", file("no-mesh.vtu")}), kInvalid);
}

TEST_F(Cli, ADocumentThatIsTooLargeIsToldWithoutALine) {
  std::ofstream(folder_ / "big.json") << std::string((std::size_t{4} << 20) + 1, ' ');
  EXPECT_EQ(run({"validate", file("big.json")}), kInvalid);
  EXPECT_NE(err_.str(), "");
  EXPECT_THAT(err_.str(), Not(HasSubstr("line ")));
}

TEST_F(Cli, AMeshCutInItsLastNumberExits3) {
  std::string nodes = "*NODE\n";
  for (int n = 1; n <= 12; ++n)
    nodes += std::to_string(n) + ", " + std::to_string(n) + ", " + std::to_string(n * n) + ", " +
             std::to_string(n * n * n) + "\n";
  const std::string tets = nodes + "*ELEMENT, TYPE=C3D4\n1, 2, 5, 4, 1";
  std::ofstream(folder_ / "whole.inp") << tets << "2";
  std::ofstream(folder_ / "cut.inp") << tets;
  EXPECT_EQ(run({"quality", file("whole.inp")}), kFine) << err_.str();
  EXPECT_EQ(run({"quality", file("cut.inp")}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("its last line may be cut"));
}

TEST_F(Cli, FilesThatCannotBeReadExit8) {
  const std::string out = file("m.vtu");
  const std::string edit = kCases + "/simple-ab.edit.json";
  std::filesystem::create_directory(folder_ / "folder.json");
  for (const char* name : {"absent.json", "folder.json"}) {
    EXPECT_EQ(run({"mesh", file(name), "-o", out}), kFileFailed) << name;
    EXPECT_EQ(run({"edit", file(name), edit, "-o", out}), kFileFailed) << name;
    EXPECT_EQ(run({"edit", "simple", file(name), "-o", out}), kFileFailed) << name;
    EXPECT_EQ(run({"validate", file(name)}), kFileFailed) << name;
    EXPECT_THAT(err_.str(), HasSubstr(name));
  }
  EXPECT_EQ(run({"validate", "no-such-file"}), kFileFailed);
  EXPECT_EQ(run({"quality", file("absent.vtu")}), kFileFailed);
  EXPECT_THAT(service_.requests, SizeIs(0));
}

TEST_F(Cli, FilesThatCannotBeWrittenExit8) {
  const std::string model = kCases + "/simple-a.json";
  const std::string out = file("m.vtu"), lost = file("nowhere/m.vtu");
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"mesh", model, "-o", lost},
           {"mesh", model, "-o", out, "--json", file("nowhere/r.json")},
           {"edit", "simple", kCases + "/simple-ab.edit.json", "-o", lost},
           {"get", "simple", "-o", lost},
           {"sweep", "simple", "top_x", "1", "3", "3", "-o", "/dev/full"}}) {
    EXPECT_EQ(run(arguments), kFileFailed) << testing::PrintToString(arguments);
    EXPECT_NE(err_.str(), "");
  }
  EXPECT_THAT(service_.requests, SizeIs(0)) << "nothing is meshed for it";
  EXPECT_EQ(run({"mesh", model, "-o", out, "--json", "/dev/full"}), kFileFailed);
  EXPECT_THAT(err_.str(), HasSubstr("/dev/full"));
  std::filesystem::create_directory(folder_ / "folder.vtu");
  EXPECT_EQ(run({"mesh", model, "-o", file("folder.vtu")}), kFileFailed);
}

TEST_F(Cli, DataThatCannotBeWrittenExit8WhateverTheCommand) {
  const std::vector<std::vector<std::string>> all{
      {"info"},
      {"types"},
      {"revisions"},
      {"head", "simple"},
      {"--help"},
      {"sweep", "--help"},
      {"mesh", kCases + "/simple-a.json", "-o", file("m.vtu")},
      {"mesh", kCases + "/simple-a.json", "-o", file("m.vtu"), "--json", "-"},
      {"sweep", "simple", "top_x", "1", "1", "1"}};
  for (const auto& arguments : all) {
    std::ofstream full("/dev/full");
    EXPECT_EQ(run(arguments, full), kFileFailed) << testing::PrintToString(arguments);
  }
}

TEST_F(Cli, ASweepEndsWithTheFirstRowThatCannotBeWritten) {
  std::ofstream full("/dev/full");
  EXPECT_EQ(run({"sweep", "simple", "top_x", "1", "3", "3"}, full), kFileFailed);
  EXPECT_THAT(service_.requests, SizeIs(0));
}

struct Failure {
  Error::Code code;
  Error::Reason reason;
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
  EXPECT_EQ(run({"--patience", "0", "diff", "a", "b"}), GetParam().exit);
  EXPECT_EQ(run({"--patience", "0", "get", "a", "-o", file("m.vtu")}), GetParam().exit);
}

INSTANTIATE_TEST_SUITE_P(
    All, CliFailure,
    testing::Values(Failure{Error::CODE_INVALID_ARGUMENT, Error::DEGENERATE_FEATURE, 3},
                    Failure{Error::CODE_NOT_FOUND, Error::REVISION_NOT_FOUND, 3},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::BOUNDARY_NOT_RECOVERED, 4},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::EMPTY_MODEL, 3},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::DISCONNECTED_MODEL, 3},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::NON_MANIFOLD_MODEL, 3},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::HEAD_PROTECTED, 3},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::DESIGN_ELSEWHERE, 3},
                    Failure{Error::CODE_INVALID_ARGUMENT, Error::DOCUMENT_TOO_LARGE, 3},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::WARNING_IS_ERROR, 4},
                    Failure{Error::CODE_UNIMPLEMENTED, Error::UNSUPPORTED, 3},
                    Failure{Error::CODE_DATA_LOSS, Error::NOT_REPRODUCIBLE, 8},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::STORE_LOCKED, 6},
                    Failure{Error::CODE_FAILED_PRECONDITION, Error::STORE_NEWER, 8},
                    Failure{Error::CODE_INTERNAL, Error::STORE_CORRUPTED, 8},
                    Failure{Error::CODE_DEADLINE_EXCEEDED, Error::DEADLINE_PASSED, 4},
                    Failure{Error::CODE_INTERNAL, Error::INTERNAL, 4},
                    Failure{Error::CODE_UNAVAILABLE, Error::SHUTTING_DOWN, 5},
                    Failure{Error::CODE_RESOURCE_EXHAUSTED, Error::BUSY, 6},
                    Failure{Error::CODE_ABORTED, Error::HEAD_CONFLICT, 6},
                    Failure{Error::CODE_PERMISSION_DENIED, Error::NOT_ALLOWED, 7},
                    Failure{Error::CODE_UNAUTHENTICATED, Error::CREDENTIALS_MISSING, 7}),
    [](const auto& failure) {
      return client::code_name(failure.param.code) + "_" + Error::Reason_Name(failure.param.reason);
    });

TEST_F(Cli, AMessageThatGrpcFindsTooLargeExits3) {
  auto error = make_error(Error::CODE_RESOURCE_EXHAUSTED, Error::REASON_UNSPECIFIED);
  error.set_message("Received message larger than max (5 vs. 4)");
  service_.failure = error;
  EXPECT_EQ(run({"diff", "a", "b"}), kInvalid);
}

TEST_F(Cli, TellsCodeReasonAndStageOnRequest) {
  service_.failure = make_error(Error::CODE_NOT_FOUND, Error::DESIGN_NOT_FOUND);
  EXPECT_EQ(run({"-v", "log", "d"}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("code NOT_FOUND, reason DESIGN_NOT_FOUND, stage "));
}

TEST_F(Cli, TellsTheHintOfAnErrorOnALineOfItsOwn) {
  auto error = make_error(Error::CODE_NOT_FOUND, Error::DESIGN_NOT_FOUND);
  service_.failure = error;
  EXPECT_EQ(run({"log", "d"}), kInvalid);
  EXPECT_THAT(err_.str(), Not(HasSubstr("hint")));
  error.set_hint("list them");
  error.add_attempts("full: an inverted tet");
  service_.failure = error;
  EXPECT_EQ(run({"log", "d"}), kInvalid);
  EXPECT_THAT(err_.str(), AllOf(HasSubstr("told by the test\n"), HasSubstr("hint: list them\n"),
                                HasSubstr("tried: full: an inverted tet\n")));
}

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

}  // namespace
}  // namespace remeshd::cli
