#include "server/config/config_file.h"

#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

std::string complaint_about(const std::string& text) {
  return complaint([&] { read_config_text(text, "remeshd.toml"); });
}

TEST(ConfigFiles, HaveKeysInCamelCaseAndAreReadInSnakeCaseToo) {
  for (const char* text : {"maxNodes = 50", "max_nodes = 50"}) {
    const auto given = read_config_text(text, "remeshd.toml");
    ASSERT_EQ(given.size(), 1U);
    EXPECT_EQ(given[0].option->name, "max-nodes");
    EXPECT_EQ(given[0].value, OptionValue(std::int64_t{50}));
  }
}

TEST(ConfigFiles, WithAnUnknownKeyNameItsLineAndTheNearestRightOne) {
  EXPECT_EQ(complaint_about("workers = 2\nmaxNode = 5\n"),
            "remeshd.toml:2: maxNode is unknown; did you mean `maxNodes`?");
  EXPECT_EQ(complaint_about("max-nodes = 5"),
            "remeshd.toml:1: max-nodes is unknown; did you mean `maxNodes`?");
  EXPECT_EQ(complaint_about("lisetn = \"127.0.0.1:1\""),
            "remeshd.toml:1: lisetn is unknown; did you mean `listen`?");
  EXPECT_EQ(complaint_about("zebra = 1"), "remeshd.toml:1: zebra is unknown");
  EXPECT_EQ(complaint_about("[limits]\nmaxNodes = 5"), "remeshd.toml:1: limits is unknown");
}

TEST(ConfigFiles, WithAValueOfAnotherKindSayWhichOneItIsToBe) {
  EXPECT_EQ(complaint_about("maxNodes = \"50\""),
            "remeshd.toml:1: maxNodes is to be a whole number");
  EXPECT_EQ(complaint_about("maxNodes = 5.5"), "remeshd.toml:1: maxNodes is to be a whole number");
  EXPECT_EQ(complaint_about("maxNodes = true"), "remeshd.toml:1: maxNodes is to be a whole number");
  EXPECT_EQ(complaint_about("queueWait = nan"), "remeshd.toml:1: queueWait is to be a number");
  EXPECT_EQ(complaint_about("store = 5"), "remeshd.toml:1: store is to be a text");
  EXPECT_EQ(complaint_about("listen = [\"a\", 5]"),
            "remeshd.toml:1: listen is to be a list of texts");
}

TEST(ConfigFiles, TakeAWholeNumberWhereAnyIsRightAndOneTextForAList) {
  EXPECT_EQ(read_config_text("queueWait = 5", "f").at(0).value, OptionValue(5.0));
  EXPECT_EQ(read_config_text("listen = \"127.0.0.1:1\"", "f").at(0).value,
            OptionValue(std::vector<std::string>{"127.0.0.1:1"}));
}

TEST(ConfigFiles, ThatAreNoTomlNameTheLine) {
  EXPECT_THAT(complaint_about("workers = 2\nmaxNodes 5\n"),
              testing::StartsWith("remeshd.toml:2: "));
  EXPECT_THAT(complaint_about("workers = 2\nworkers = 3\n"),
              testing::StartsWith("remeshd.toml:2: "));
  EXPECT_THAT(complaint_about(std::string(100000, '[')), testing::StartsWith("remeshd.toml:1: "));
}

TEST(ConfigFiles, ThatAreNoTomlAreRefusedWithAssertionsToo) {
  for (const char* text : {"[%", "[[%", "a.% = 1", "[a.%]"})
    EXPECT_THAT(complaint_about(text), testing::StartsWith("remeshd.toml:1: ")) << text;
}

TEST(ConfigFiles, WithAKeyInBothWaysOfWritingAreRefused) {
  EXPECT_THAT(complaint_about("maxNodes = 50\nmax_nodes = 60"),
              testing::HasSubstr("is given twice"));
}

TEST(ConfigFiles, ThatCannotBeReadAreNamed) {
  const Folder folder;
  EXPECT_THAT(complaint([&] { read_config_file(folder.file("none.toml")); }),
              testing::EndsWith("none.toml: No such file or directory"));
  EXPECT_THAT(complaint([&] { read_config_file(folder.file("")); }),
              testing::HasSubstr(folder.file("")));
  const ConfigFile large(std::string((1 << 20) + 1, '#'));
  EXPECT_THAT(complaint([&] { read_config_file(large.path()); }),
              testing::HasSubstr("has more than 1048576 bytes"));
}

}  // namespace
}  // namespace remeshd::test
