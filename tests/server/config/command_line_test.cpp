#include "server/config/command_line.h"

#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

TEST(CommandLines, WithAnUnknownFlagSuggestTheNearestOne) {
  EXPECT_EQ(complaint([] {
              read_command_line({"--max-node", "5"});
            }),
            "--max-node is unknown; did you mean `--max-nodes`?");
  EXPECT_EQ(complaint([] { read_command_line({"--conifg=x"}); }),
            "--conifg is unknown; did you mean `--config`?");
  EXPECT_EQ(complaint([] { read_command_line({"stray"}); }), "stray belongs to no flag");
}

TEST(CommandLines, WithAWrongValueNameTheFlag) {
  EXPECT_EQ(complaint([] {
              read_command_line({"--workers", "two"});
            }),
            "--workers: `two` is not a whole number");
  EXPECT_EQ(complaint([] {
              read_configuration({"--max-nodes", "19"}, {});
            }),
            "--max-nodes: 19 is less than 20");
  EXPECT_EQ(complaint([] {
              read_configuration({"--queue-wait", "1e300"}, {});
            }),
            "--queue-wait: 1e+300 is more than a year");
  EXPECT_THAT(complaint([] {
                read_configuration({"--log-level", "loud"}, {});
              }),
              HasSubstr("`loud` is none of: trace, debug"));
  EXPECT_THAT(complaint([] { read_command_line({"--workers"}); }), HasSubstr("--workers"));
}

TEST(CommandLines, WithAFlagTwiceAreRefusedButForLists) {
  EXPECT_THAT(complaint([] {
                read_command_line({"--workers", "1", "--workers", "2"});
              }),
              HasSubstr("--workers"));
  const auto line = read_command_line({"--listen", "127.0.0.1:1", "--listen", "127.0.0.1:2"});
  EXPECT_EQ(line.given.at(0).value,
            OptionValue(std::vector<std::string>{"127.0.0.1:1", "127.0.0.1:2"}));
}

TEST(CommandLines, MayHaveSeveralValuesBehindAFlagOfAList) {
  const auto line = read_command_line({"--listen", "127.0.0.1:1", "127.0.0.1:2"});
  EXPECT_EQ(line.given.at(0).value,
            OptionValue(std::vector<std::string>{"127.0.0.1:1", "127.0.0.1:2"}));
}

TEST(CommandLines, KeepATextWithoutLetters) {
  EXPECT_EQ(read_command_line({"--store", ""}).given.at(0).value, OptionValue(std::string()));
  EXPECT_EQ(read_command_line({"--listen", ""}).given.at(0).value,
            OptionValue(std::vector<std::string>{""}));
  EXPECT_EQ(read_command_line({"--listen", "[::1]:5"}).given.at(0).value,
            OptionValue(std::vector<std::string>{"[::1]:5"}));
}

TEST(CommandLines, TellEveryOptionInTheHelp) {
  const auto line = read_command_line({"--help"});
  ASSERT_TRUE(line.answer);
  for (const Option& option : option_table())
    EXPECT_THAT(*line.answer, HasSubstr(option.flag() + ' '));
  EXPECT_THAT(*read_command_line({"--version"}).answer, HasSubstr("remeshd 0."));
}

TEST(CommandLines, ChooseTheTask) {
  EXPECT_EQ(read_command_line({}).task, Task::Serve);
  EXPECT_EQ(read_command_line({"--check-config"}).task, Task::CheckConfig);
  EXPECT_EQ(read_command_line({"--print-config"}).task, Task::PrintConfig);
}

}  // namespace
}  // namespace remeshd::test
