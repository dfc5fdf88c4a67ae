#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/cli/choice.h"
#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct UnknownWord {
  std::vector<std::string> arguments;
  std::string told;
};

TEST_F(Cli, AnUnknownWordIsToldWithTheOneThatMayBeMeant) {
  const std::vector<UnknownWord> all{
      {{"mehs", "part.json"}, "unknown command mehs; did you mean `mesh`?"},
      {{"frobnicate"}, "unknown command frobnicate\n"},
      {{"cache", "verfy"}, "unknown command verfy; did you mean `verify`?"},
      {{"mesh", "a.json", "--ouput", "b.vtu"}, "unknown option --ouput; did you mean `--output`?"},
      {{"mesh", "a.json", "-o", "b.vtu", "--iteration=3"}, "did you mean `--iterations`?"},
      {{"log", "d", "--adress", "x:1"}, "unknown option --adress; did you mean `--address`?"},
      {{"mesh", "a.json", "-o", "-", "--format", "vut"}, "did you mean `vtu`?"},
      {{"example", "braket"}, "did you mean `bracket`?"},
      {{"schema", "modle"}, "did you mean `model`?"},
      {{"completion", "bsh"}, "did you mean `bash`?"},
      {{"mesh", "a.json", "-o", "b.vtu", "--fail-on", "GROUP_EMPTYD"},
       "did you mean `GROUP_EMPTIED`?"}};
  for (const UnknownWord& each : all) {
    EXPECT_EQ(run(each.arguments), kUsage) << testing::PrintToString(each.arguments);
    EXPECT_THAT(err_.str(), HasSubstr(each.told));
    EXPECT_EQ(out_.str(), "");
  }
}

TEST_F(Cli, AKnownCommandWithoutWhatItNeedsIsNoUnknownWord) {
  EXPECT_EQ(run({"log"}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("DESIGN is required"));
  EXPECT_EQ(run({"log", "a", "b"}), kUsage);
  EXPECT_THAT(err_.str(), HasSubstr("b"));
  EXPECT_EQ(run({"cache"}), kUsage);
  EXPECT_EQ(run({}), kUsage);
}

TEST(Choice, WordsOfAListAreThoseInSmallLetters) {
  EXPECT_THAT(words_of("vtu|msh|inp"), ElementsAre("vtu", "msh", "inp"));
  EXPECT_THAT(words_of("K|auto"), ElementsAre("auto"));
  EXPECT_THAT(words_of("FILE"), IsEmpty());
  EXPECT_THAT(words_of(""), IsEmpty());
}

}  // namespace
}  // namespace remeshd::cli
