#include "tests/daemon/process.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

/// What remeshd prints, and how it exits.
struct Answer {
  std::string text;
  int exit_code;
};

Answer answer_to(std::vector<std::string> arguments, std::vector<std::string> settings = {}) {
  Process process(std::move(arguments), std::move(settings));
  const int status = process.wait();
  EXPECT_TRUE(WIFEXITED(status));
  return {process.log(), WEXITSTATUS(status)};
}

class ConfigFolder : public testing::Test {
 protected:
  ConfigFolder() { std::filesystem::create_directories(folder_); }
  ~ConfigFolder() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string file(const std::string& text) const {
    std::ofstream(folder_ / "remeshd.toml") << text;
    return folder_ / "remeshd.toml";
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("remeshd-config-process-" + std::to_string(::getpid()));
};

TEST_F(ConfigFolder, IsCheckedWithoutServing) {
  const Answer right = answer_to({"--config", file("maxNodes = 500\n"), "--check-config"});
  EXPECT_EQ(right.text, "OK\n");
  EXPECT_EQ(right.exit_code, 0);
  const Answer wrong = answer_to({"--config", file("maxNode = 500\n"), "--check-config"});
  EXPECT_THAT(wrong.text,
              HasSubstr("remeshd.toml:1: maxNode is unknown; did you mean `maxNodes`?"));
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_EQ(answer_to({"--listen", "0", "--check-config"}).exit_code, 1);
}

TEST_F(ConfigFolder, IsNotRightWithAnUnknownVariable) {
  const Answer answer = answer_to({"--check-config"}, {"REMESHD_MAX_NODE=5"});
  EXPECT_THAT(answer.text,
              HasSubstr("REMESHD_MAX_NODE is unknown; did you mean `REMESHD_MAX_NODES`?"));
  EXPECT_EQ(answer.exit_code, 1);
}

TEST_F(ConfigFolder, IsPrintedAsAFileThatIsPrintedTheSame) {
  const Answer first = answer_to({"--max-nodes", "700", "--print-config"}, {"REMESHD_WORKERS=3"});
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_THAT(first.text, HasSubstr("\nmaxNodes = 700\n"));
  EXPECT_THAT(first.text, HasSubstr("\nworkers = 3\n"));
  EXPECT_EQ(answer_to({"--config", file(first.text), "--print-config"}).text, first.text);
}

TEST_F(ConfigFolder, GivesADaemonItsAddress) {
  Process process({"--config", file("listen = \"127.0.0.1:0\"\n")});
  EXPECT_NE(process.address(), "") << process.log();
}

}  // namespace
}  // namespace remeshd::test
