#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Error;
using testing::HasSubstr;

TEST_F(Cli, TakesAListOfAddressesAndSaysWhichDoNotAnswer) {
  service_.failure = client::make_error(Error::CODE_UNAVAILABLE, Error::SHUTTING_DOWN);
  EXPECT_EQ(run({"revisions", "--address", "a:1, b:2,unix:/c", "--patience", "0"}), kUnreachable);
  EXPECT_EQ(seen_.address, "a:1, b:2,unix:/c");
  EXPECT_THAT(err_.str(), HasSubstr("no answer from a daemon at a:1 or b:2 or unix:/c;"));
}

TEST_F(Cli, TriesAgainForAsLongAsPatienceSays) {
  auto starting = client::make_error(Error::CODE_UNAVAILABLE, Error::STARTING);
  starting.set_retry_after(0.2);
  service_.failure = starting;
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(run({"revisions", "--patience", "0.5"}), kUnreachable);
  EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(350));
  EXPECT_EQ(service_.keys.size(), 3U);
}

TEST_F(Cli, TellsWhereADesignLives) {
  auto elsewhere = client::make_error(Error::CODE_FAILED_PRECONDITION, Error::DESIGN_ELSEWHERE);
  elsewhere.set_home("10.0.0.9:50051");
  service_.failure = elsewhere;
  EXPECT_EQ(run({"log", "plate"}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("daemon 10.0.0.9:50051"));
}

}  // namespace
}  // namespace remeshd::cli
