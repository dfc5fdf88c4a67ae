#include "server/transport/listening_sockets.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <optional>

#include "engine/base/error.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

ListeningSockets listen(const std::string& text) {
  return ListeningSockets(parse_listen_address(text));
}

void expect_failure(const std::string& text) {
  try {
    const ListeningSockets sockets = listen(text);
    ADD_FAILURE() << "listens on " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.info().reason, "LISTEN_FAILED");
    EXPECT_EQ(error.info().kind, ErrorKind::FailedPrecondition);
    EXPECT_THAT(error.info().message, testing::HasSubstr(text));
  }
}

TEST(ListeningSockets, TakeAFreePortAndTellIt) {
  const ListeningSockets sockets = listen("127.0.0.1:0");
  EXPECT_GT(sockets.port(), 0);
  EXPECT_EQ(sockets.name(), "127.0.0.1:" + std::to_string(sockets.port()));
  EXPECT_TRUE(connect_to(sockets.name()).is_open());
}

TEST(ListeningSockets, OfLocalhostHaveOnePortInBothFamilies) {
  const ListeningSockets sockets = listen("localhost:0");
  const std::string port = std::to_string(sockets.port());
  EXPECT_EQ(sockets.name(), "localhost:" + port);
  EXPECT_TRUE(connect_to("127.0.0.1:" + port).is_open());
  if (sockets.descriptors().size() == 2) {
    EXPECT_TRUE(connect_to("[::1]:" + port).is_open());
  }
}

TEST(ListeningSockets, DoNotShareAPort) {
  const ListeningSockets first = listen("127.0.0.1:0");
  expect_failure(first.name());
  expect_failure("localhost:" + std::to_string(first.port()));
}

TEST(ListeningSockets, NeedAnAddressOfThisMachine) { expect_failure("192.0.2.1:1024"); }

TEST(ListeningSockets, CloseOnceIsAsTwice) {
  ListeningSockets sockets = listen("127.0.0.1:0");
  sockets.close();
  sockets.close();
  EXPECT_FALSE(connect_to(sockets.name()).is_open());
}

TEST(ListeningSockets, OfAUnixPathAreTheOwnersAloneAndGoWithTheObject) {
  const Folder folder;
  const std::string path = folder.file("socket");
  {
    const ListeningSockets sockets = listen("unix:" + path);
    EXPECT_EQ(sockets.name(), "unix:" + path);
    EXPECT_EQ(sockets.port(), 0);
    struct stat file {};
    ASSERT_EQ(::lstat(path.c_str(), &file), 0);
    EXPECT_TRUE(S_ISSOCK(file.st_mode));
    EXPECT_EQ(file.st_mode & 0777U, 0600U);
    EXPECT_TRUE(connect_to(sockets.name()).is_open());
    expect_failure("unix:" + path);
    EXPECT_TRUE(connect_to(sockets.name()).is_open());
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(ListeningSockets, ReplaceTheSocketOfADaemonThatWasKilled) {
  const Folder folder;
  const std::string path = folder.file("socket");
  const std::string other = folder.file("other");
  std::optional<ListeningSockets> killed = listen("unix:" + path);
  fs::create_hard_link(path, other);
  killed.reset();
  fs::rename(other, path);  // the file stays, as after a kill
  ASSERT_FALSE(connect_to("unix:" + path).is_open());
  const ListeningSockets sockets = listen("unix:" + path);
  EXPECT_TRUE(connect_to("unix:" + path).is_open());
}

TEST(ListeningSockets, LeaveAnyOtherFileAlone) {
  const Folder folder;
  const std::string text = folder.file("text");
  std::ofstream(text) << "precious";
  expect_failure("unix:" + text);
  EXPECT_EQ(fs::file_size(text), 8U);
  const std::string link = folder.file("link");
  fs::create_symlink(folder.file("nowhere"), link);
  expect_failure("unix:" + link);
  EXPECT_TRUE(fs::is_symlink(link));
  expect_failure("unix:" + folder.file("no-such-folder/socket"));
}

}  // namespace
}  // namespace remeshd::test
