#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <regex>
#include <thread>

#include "tests/server/daemon_fixture.h"

extern char** environ;

namespace remeshd::test {

/// `build/bin/remeshd` as a process, with its log in a file.
class Process {
 public:
  /// `settings`: `NAME=value`, beside this process' environment.
  explicit Process(std::vector<std::string> arguments, std::vector<std::string> settings = {})
      : log_(std::filesystem::temp_directory_path() /
             ("remeshd-process-test-" + std::to_string(::getpid()) + "-" +
              std::to_string(++counter_))) {
    std::ofstream(log_).close();
    std::vector<char*> environment;
    for (std::string& setting : settings) environment.push_back(setting.data());
    for (char** setting = environ; *setting != nullptr; ++setting) environment.push_back(*setting);
    environment.push_back(nullptr);
    arguments.insert(arguments.begin(), REMESHD_BINARY);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int stream : {1, 2})
      posix_spawn_file_actions_addopen(&files, stream, log_.c_str(), O_WRONLY | O_APPEND, 0);
    EXPECT_EQ(posix_spawn(&id_, REMESHD_BINARY, &files, nullptr, argv.data(), environment.data()),
              0);
    posix_spawn_file_actions_destroy(&files);
  }
  ~Process() {
    if (id_ > 0) {
      ::kill(id_, SIGKILL);
      wait();
    }
    std::filesystem::remove(log_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] std::string log() const {
    std::ifstream in(log_);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Where it serves, once its log says so; empty after 10 s.
  [[nodiscard]] std::string address() const {
    for (int i = 0; i < 1000; ++i) {
      std::smatch match;
      const std::string text = log();
      if (std::regex_search(text, match,
                            std::regex("serving remesh.v1 on (127[0-9.]*:[0-9]+|unix:[^,]*)")))
        return match[1];
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return "";
  }
  /// A line of /proc/PID/status that tells bytes: `VmRSS`, `VmHWM` (the highest so far).
  [[nodiscard]] std::size_t memory(const std::string& line) const {
    std::ifstream in("/proc/" + std::to_string(id_) + "/status");
    for (std::string name; in >> name;) {
      std::size_t kilobytes = 0;
      if (name == line + ":" && in >> kilobytes) return kilobytes << 10U;
    }
    ADD_FAILURE() << "no " << line;
    return 0;
  }
  [[nodiscard]] pid_t id() const { return id_; }
  void signal(int number) const { ::kill(id_, number); }
  /// Its exit status.
  int wait() {
    int status = 0;
    ::waitpid(id_, &status, 0);
    id_ = 0;
    return status;
  }

 private:
  static inline int counter_ = 0;
  std::filesystem::path log_;
  pid_t id_ = 0;
};

inline std::unique_ptr<v1::RemeshService::Stub> connect(const Process& process) {
  const std::string address = process.address();
  EXPECT_NE(address, "") << process.log();
  return v1::RemeshService::NewStub(
      grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
}

}  // namespace remeshd::test
