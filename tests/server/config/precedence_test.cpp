#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

std::uint32_t max_nodes(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& environment) {
  return read_configuration(arguments, environment).settings.daemon.max_nodes;
}

TEST(ConfigurationPrecedence, FileThenEnvironmentThenFlag) {
  const ConfigFile file("maxNodes = 1000\n");
  EXPECT_EQ(max_nodes({}, {}), 5000000U);
  EXPECT_EQ(max_nodes({"--config", file.path()}, {}), 1000U);
  EXPECT_EQ(max_nodes({"--config", file.path()}, {"REMESHD_MAX_NODES=2000"}), 2000U);
  EXPECT_EQ(max_nodes({"--config", file.path(), "--max-nodes", "3000"}, {"REMESHD_MAX_NODES=2000"}),
            3000U);
  EXPECT_EQ(max_nodes({"--max-nodes=3000"}, {"REMESHD_MAX_NODES=2000"}), 3000U);
}

TEST(ConfigurationPrecedence, HoldsForTheNameOfTheFileToo) {
  const ConfigFile first("maxNodes = 1000\n");
  const ConfigFile second("maxNodes = 1001\n");
  EXPECT_EQ(max_nodes({}, {"REMESHD_CONFIG=" + first.path()}), 1000U);
  EXPECT_EQ(max_nodes({"--config", second.path()}, {"REMESHD_CONFIG=" + first.path()}), 1001U);
}

TEST(ConfigurationPrecedence, ReplacesAListAsAWhole) {
  const ConfigFile file("listen = [\"127.0.0.1:1\", \"127.0.0.1:2\"]\n");
  const auto listen = [&](std::vector<std::string> arguments,
                          const std::vector<std::string>& environment) {
    arguments.insert(arguments.begin(), {"--config", file.path()});
    return read_configuration(arguments, environment).settings.daemon.listen;
  };
  using testing::ElementsAre;
  EXPECT_THAT(listen({}, {}), ElementsAre("127.0.0.1:1", "127.0.0.1:2"));
  EXPECT_THAT(listen({}, {"REMESHD_LISTEN=127.0.0.1:3,unix:/a"}),
              ElementsAre("127.0.0.1:3", "unix:/a"));
  EXPECT_THAT(
      listen({"--listen", "127.0.0.1:4", "--listen", "unix:/b"}, {"REMESHD_LISTEN=127.0.0.1:3"}),
      ElementsAre("127.0.0.1:4", "unix:/b"));
}

TEST(ConfigurationPrecedence, LetsEveryOptionBeGivenInEachOfTheThreeWays) {
  // Another value than the default, as text; what is not here has one by its kind.
  const std::map<std::string, std::string> others{
      {"log-level", "debug"}, {"log-format", "json"}, {"tier-ack", "tier"}};
  for (const Option& option : option_table()) {
    const Settings defaults;
    std::string text;
    switch (option.kind) {
      case OptionKind::Switch:
        text = "true";
        break;
      case OptionKind::Whole:
        text = "77";
        break;
      case OptionKind::Number:
        text = "7.5";
        break;
      case OptionKind::Text:
        text = "words";
        break;
      case OptionKind::List:
        text = "127.0.0.1:77";
        break;
    }
    if (others.contains(option.name)) text = others.at(option.name);
    const OptionValue value = parse_option_value(option.kind, text);
    ASSERT_NE(option.get(defaults), value) << option.name;
    for (const std::string& key : {option.key(), option.snake_key()}) {
      const ConfigFile file(key + " = " + to_toml(value) + '\n');
      EXPECT_EQ(option.get(read_configuration({"--config", file.path()}, {}).settings), value)
          << key;
    }
    EXPECT_EQ(option.get(read_configuration({}, {option.variable() + '=' + text}).settings), value)
        << option.variable();
    EXPECT_EQ(option.get(read_configuration({option.flag() + '=' + text}, {}).settings), value)
        << option.flag();
  }
}

}  // namespace
}  // namespace remeshd::test
