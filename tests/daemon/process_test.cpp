#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <regex>
#include <thread>

#include "tests/server/daemon_fixture.h"

extern char** environ;

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// `build/bin/remeshd` as a process, with its log in a file.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments)
      : log_(fs::temp_directory_path() / ("remeshd-process-test-" + std::to_string(::getpid()) +
                                          "-" + std::to_string(++counter_))) {
    std::ofstream(log_).close();
    arguments.insert(arguments.begin(), REMESHD_BINARY);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int stream : {1, 2})
      posix_spawn_file_actions_addopen(&files, stream, log_.c_str(), O_WRONLY | O_APPEND, 0);
    EXPECT_EQ(posix_spawn(&id_, REMESHD_BINARY, &files, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&files);
  }
  ~Process() {
    if (id_ > 0) {
      ::kill(id_, SIGKILL);
      wait();
    }
    fs::remove(log_);
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
      if (std::regex_search(text, match, std::regex("serving remesh.v1 on (127[0-9.]*:[0-9]+)")))
        return match[1];
      std::this_thread::sleep_for(10ms);
    }
    return "";
  }
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
  fs::path log_;
  pid_t id_ = 0;
};

std::unique_ptr<v1::Remesh::Stub> connect(const Process& process) {
  const std::string address = process.address();
  EXPECT_NE(address, "") << process.log();
  return v1::Remesh::NewStub(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
}

class EndingProcess : public testing::TestWithParam<int> {};

TEST_P(EndingProcess, EndsAComputationAndItselfWithExitZero) {
  Process process({"--listen", "127.0.0.1:0"});
  const auto stub = connect(process);
  grpc::ClientContext context;
  const auto stream = stub->EditStream(&context);
  v1::EditStreamRequest request;
  *request.mutable_create()->mutable_model() = plate();
  request.mutable_create()->mutable_options()->set_nodes(500000);
  ASSERT_TRUE(stream->Write(request));
  v1::EditStreamReply reply;
  do ASSERT_TRUE(stream->Read(&reply)) << process.log();
  while (reply.progress().stage() == "queued");
  process.signal(GetParam());
  while (stream->Read(&reply) && reply.has_progress()) {
  }
  EXPECT_EQ(reply.error().code(), v1::Error::UNAVAILABLE) << reply.ShortDebugString();
  const int status = process.wait();
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << process.log();
}

INSTANTIATE_TEST_SUITE_P(Signals, EndingProcess, testing::Values(SIGTERM, SIGINT));

TEST(Process, KilledInTheMiddleLeavesAStoreThatOpensAgain) {
  const fs::path folder =
      fs::temp_directory_path() / ("remeshd-killed-" + std::to_string(::getpid()));
  fs::remove_all(folder);
  std::string id;
  {
    Process process({"--listen", "127.0.0.1:0", "--store", folder});
    const auto stub = connect(process);
    v1::CreateRevisionRequest request;
    *request.mutable_model() = plate();
    request.mutable_options()->set_nodes(300);
    grpc::ClientContext context;
    v1::RevisionReply reply;
    const auto status = stub->CreateRevision(&context, request, &reply);
    ASSERT_TRUE(status.ok()) << status.error_message();
    id = reply.revision().id();
    process.signal(SIGKILL);
    process.wait();
  }
  Process process({"--listen", "127.0.0.1:0", "--store", folder});
  const auto stub = connect(process);
  grpc::ClientContext context;
  v1::DescribeRevisionRequest request;
  request.set_revision("plate");
  v1::RevisionDescription reply;
  const auto status = stub->DescribeRevision(&context, request, &reply);
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(reply.revision().id(), id);
  process.signal(SIGTERM);
  process.wait();
  fs::remove_all(folder);
}

TEST(Process, WithAPortThatIsTakenSaysSoAndFails) {
  Process first({"--listen", "127.0.0.1:0"});
  Process second({"--listen", first.address()});
  const int status = second.wait();
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_NE(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace remeshd::test
