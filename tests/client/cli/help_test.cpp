#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "client/cli/command_line.h"
#include "client/cli/completion.h"
#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct HelpFixture : testing::Test {
  HelpFixture() { build(app, line); }
  Line line;
  CLI::App app{"", "remesh"};
};

void collect(const CLI::App& app, std::vector<const CLI::App*>& all) {
  all.push_back(&app);
  for (const CLI::App* each : commands_of(app)) collect(*each, all);
}

/// The command lines among the examples of a help text, without `remesh` and what a shell takes.
std::vector<std::vector<std::string>> examples_in(const std::string& footer) {
  std::vector<std::vector<std::string>> all;
  std::istringstream in(footer.substr(std::min(footer.size(), footer.rfind("Example"))));
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("  remesh")) continue;
    std::istringstream words(line.substr(0, line.find_first_of("<>")));
    auto& arguments = all.emplace_back();
    for (std::string word; words >> word;) arguments.push_back(word);
    arguments.erase(arguments.begin());
  }
  return all;
}

TEST_F(HelpFixture, EveryCommandHasAnExampleAndEachParses) {
  std::vector<const CLI::App*> all;
  collect(app, all);
  EXPECT_GT(all.size(), 25U);
  for (const CLI::App* command : all) {
    const auto examples = examples_in(command->get_footer());
    EXPECT_THAT(examples, Not(IsEmpty())) << command->get_name();
    for (const auto& example : examples) {
      Line parsed;
      CLI::App fresh("", "remesh");
      build(fresh, parsed);
      EXPECT_NO_THROW(fresh.parse(std::vector<std::string>(example.rbegin(), example.rend())))
          << testing::PrintToString(example);
      EXPECT_TRUE(parsed.action);
      if (command != &app) {
        EXPECT_TRUE(fresh.got_subcommand(example.front()));
        EXPECT_EQ(command->get_name(),
                  command->get_parent() == &app ? example.at(0) : example.at(1));
      }
    }
  }
}

TEST_F(HelpFixture, CompletionsHaveEveryCommandAndOption) {
  std::vector<const CLI::App*> all;
  collect(app, all);
  const std::string bash = bash_completion(app), zsh = zsh_completion(app),
                    fish = fish_completion(app);
  for (const CLI::App* command : all) {
    if (command == &app) continue;
    for (const std::string& script : {bash, zsh, fish})
      EXPECT_THAT(script, HasSubstr(command->get_name()));
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) {
        EXPECT_THAT(bash, HasSubstr("--" + name));
        EXPECT_THAT(zsh, HasSubstr("--" + name));
        EXPECT_THAT(fish, HasSubstr(" -l " + name + " "));
      }
  }
}

TEST_F(Cli, EveryExampleIsListedWithWordsAboutIt) {
  ASSERT_EQ(run({"example"}), kFine);
  std::istringstream lines(out_.str());
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    names.push_back(line.substr(0, line.find(' ')));
    EXPECT_NE(line.find_first_not_of(' ', names.back().size()), std::string::npos) << line;
  }
  EXPECT_THAT(names, testing::ElementsAre("bracket", "bracket.edit", "mount", "plate"));
  for (const std::string& name : names) {
    ASSERT_EQ(run({"example", name, "-o", file("e.json")}), kFine) << err_.str();
    ASSERT_EQ(run({"validate", file("e.json")}), kFine) << err_.str();
  }
  ASSERT_EQ(run({"example", "mount"}), kFine);
  EXPECT_EQ(nlohmann::json::parse(out_.str()),
            nlohmann::json::parse(std::ifstream(kCases + "/detailed/mount.json")));
}

}  // namespace
}  // namespace remeshd::cli
