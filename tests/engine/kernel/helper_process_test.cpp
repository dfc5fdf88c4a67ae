#include "engine/kernel/helper_process.h"

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "engine/kernel/tetgen.h"

namespace remeshd {
namespace {

TEST(HelperProcesses, GetNoEnvironment) {
  ::setenv("REMESHD_SECRET", "of the daemon", 1);
  const auto end = kernel::run_helper("/usr/bin/env", {}, {}, {.seconds = 10, .answer_bytes = 1000},
                                      remeshd::Run{});
  EXPECT_EQ(end.kind, kernel::HelperEnd::Kind::Exited);
  const std::string text(reinterpret_cast<const char*>(end.answer.data()), end.answer.size());
  EXPECT_EQ(text, "");
}

/// The helper as a process that waits for its input.
class WaitingHelper {
 public:
  WaitingHelper() {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_), 0);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int stream : {0, 1}) posix_spawn_file_actions_adddup2(&files, ends_[1], stream);
    const std::string path = kernel::find_tetgen_helper();
    std::string name = "remeshd-tetgen", bytes = "1000000000", seconds = "10";
    char* arguments[] = {name.data(), bytes.data(), seconds.data(), nullptr};
    char* environment[] = {nullptr};
    EXPECT_EQ(posix_spawn(&id_, path.c_str(), &files, nullptr, arguments, environment), 0) << path;
    posix_spawn_file_actions_destroy(&files);
  }
  ~WaitingHelper() {
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
    for (const int end : ends_) ::close(end);
  }
  /// A line of /proc/PID/limits, once it says so; else as it is after 10 s.
  [[nodiscard]] std::string limit(const std::string& name, const std::string& wanted) const {
    std::string line;
    for (int i = 0; i < 1000 && line.find(wanted) == std::string::npos; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::ifstream in("/proc/" + std::to_string(id_) + "/limits");
      while (std::getline(in, line) && !line.starts_with(name)) {
      }
    }
    return line;
  }

 private:
  int ends_[2];
  pid_t id_ = 0;
};

TEST(HelperProcesses, MayNeitherWriteFilesNorOpenAny) {
  const WaitingHelper helper;
  const std::string files = helper.limit("Max open files", " 0 ");
  EXPECT_NE(files.find(" 0 "), std::string::npos) << files;
  const std::string size = helper.limit("Max file size", " 0 ");
  EXPECT_NE(size.find(" 0 "), std::string::npos) << size;
}

}  // namespace
}  // namespace remeshd
