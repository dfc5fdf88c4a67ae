#include "server/observe/log.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

class Logs : public testing::Test {
 protected:
  [[nodiscard]] std::string file() const { return folder_.file("log"); }
  /// What one line becomes.
  std::string line(const std::string& message, const std::string& format) {
    std::filesystem::remove(file());
    {
      const Log log({.format = format, .file = file()});
      log.logger()->warn(message);
    }
    return text(file());
  }
  static std::string text(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  Folder folder_;
};

TEST_F(Logs, HaveLinesWithTimeLevelAndMessage) {
  EXPECT_THAT(line("the disk is full", "text"),
              testing::MatchesRegex("20[0-9-]+T[0-9:.]+[+-][0-9:]+ warning the disk is full\n"));
}

TEST_F(Logs, KeepAMessageOnOneLine) {
  EXPECT_THAT(line("one\ntwo\r\x1b[31m", "text"), testing::EndsWith(" warning one_two__[31m\n"));
  const std::string json = line("one\ntwo", "json");
  EXPECT_EQ(std::ranges::count(json, '\n'), 1);
  EXPECT_EQ(nlohmann::json::parse(json)["message"], "one\ntwo");
}

TEST_F(Logs, InJsonAreObjectsWhateverTheMessageIs) {
  for (const char* message :
       {"say \"x\" \\", "", "\xFF\xFE no UTF-8", "a=b", "=", "level=x time=y"}) {
    const auto object = nlohmann::json::parse(line(message, "json"));
    EXPECT_EQ(object["level"], "warning") << message;
    EXPECT_THAT(object["time"].get<std::string>(),
                testing::MatchesRegex("20..-..-..T..:..:..[.]...Z"));
    EXPECT_TRUE(object["message"].is_string());
  }
}

TEST_F(Logs, InJsonGiveTheWordsOfACallAsFields) {
  const auto object = nlohmann::json::parse(
      line("call=7 method=GetMesh ms=0.5 status=OK request=12 note=", "json"));
  EXPECT_EQ(object["call"], 7);
  EXPECT_EQ(object["ms"], 0.5);
  EXPECT_EQ(object["method"], "GetMesh");
  EXPECT_EQ(object["request"], "12");
  const auto plain = nlohmann::json::parse(line("store: a=b was quarantined", "json"));
  EXPECT_EQ(plain.size(), 3U);
}

TEST_F(Logs, AreTheirOwnersAlone) {
  line("x", "text");
  struct stat status {};
  ASSERT_EQ(::stat(file().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(Logs, GoOnInANewFileOnceTheOldOneWasRenamed) {
  Log log({.file = file()});
  log.logger()->info("before");
  ASSERT_TRUE(log.flush(std::chrono::seconds(10)));
  std::filesystem::rename(file(), folder_.file("old"));
  log.logger()->info("between");
  ASSERT_TRUE(log.flush(std::chrono::seconds(10)));
  log.reopen();
  log.logger()->info("after");
  ASSERT_TRUE(log.flush(std::chrono::seconds(10)));
  EXPECT_THAT(text(folder_.file("old")), HasSubstr("between"));
  EXPECT_THAT(text(file()), testing::AllOf(HasSubstr("after"), testing::Not(HasSubstr("between"))));
}

TEST_F(Logs, NeverWaitForWhoeverReadsThemAndTellHowMuchWasDropped) {
  ASSERT_EQ(::mkfifo(file().c_str(), 0600), 0);
  const Descriptor reader(::open(file().c_str(), O_RDONLY | O_NONBLOCK));
  Log log({.file = file(), .queue = 64});
  // Until the pipe is full.
  while (log.flush(std::chrono::milliseconds(500))) log.logger()->info(std::string(1000, 'x'));
  for (int i = 0; i < 20000; ++i) log.logger()->info("line {} of very many", i);
  EXPECT_GT(log.dropped(), 19000U);
  log.logger()->info("the last one");
  std::string text;
  while (text.find("the last one") == std::string::npos && readable(reader)) {
    char bytes[65536];
    const ssize_t got = ::read(reader.get(), bytes, sizeof(bytes));
    if (got > 0) text.append(bytes, static_cast<std::size_t>(got));
  }
  EXPECT_THAT(text, HasSubstr("lines of the log were dropped"));
  EXPECT_THAT(text, HasSubstr("the last one"));
}

TEST_F(Logs, ThatCannotBeOpenedSaySo) {
  EXPECT_THROW(Log({.file = folder_.file("no/such/folder")}), std::system_error);
}

}  // namespace
}  // namespace remeshd::test
