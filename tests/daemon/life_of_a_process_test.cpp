#include <sys/ioctl.h>
#include <sys/stat.h>

#include "server/process/health_probe.h"
#include "server/store/store.h"
#include "tests/daemon/process.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A process with a folder for its files, and a computation that takes longer than any test.
class LifeOfAProcess : public testing::Test {
 protected:
  LifeOfAProcess() { fs::create_directories(folder_); }
  ~LifeOfAProcess() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_ / name; }
  static std::string text(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  template <typename Happened>
  static bool eventually(Happened happened) {
    for (int i = 0; i < 1000 && !happened(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return happened();
  }
  /// Sends a request over the stream and returns once it is at work.
  static void begin(grpc::ClientReaderWriter<v1::EditStreamRequest, v1::EditStreamResponse>& stream,
                    std::uint32_t nodes) {
    v1::EditStreamRequest request;
    *request.mutable_create()->mutable_model() = plate();
    request.mutable_create()->mutable_options()->set_nodes(nodes);
    ASSERT_TRUE(stream.Write(request));
    v1::EditStreamResponse reply;
    do ASSERT_TRUE(stream.Read(&reply));
    while (reply.progress().stage() == "queued");
  }
  static int exit_code(Process& process) {
    const int status = process.wait();
    EXPECT_TRUE(WIFEXITED(status)) << process.log();
    return WEXITSTATUS(status);
  }
  static int health(std::vector<std::string> arguments) {
    Process probe(std::move(arguments));
    return exit_code(probe);
  }

  fs::path folder_ =
      fs::temp_directory_path() / ("remeshd-life-test-" + std::to_string(::getpid()));
};

TEST_F(LifeOfAProcess, GivesARequestTheGraceTimeToFinish) {
  Process process({"--listen", "127.0.0.1:0", "--grace", "100"});
  const auto stub = connect(process);
  grpc::ClientContext context;
  const auto stream = stub->EditStream(&context);
  begin(*stream, 15000);
  process.signal(SIGTERM);
  v1::EditStreamResponse reply;
  while (stream->Read(&reply) && reply.has_progress()) {
  }
  EXPECT_TRUE(reply.has_result()) << reply.ShortDebugString();
  EXPECT_EQ(exit_code(process), 0);
}

TEST_F(LifeOfAProcess, EndsAtOnceOnASecondSignalAndNotWithExitZero) {
  Process process({"--listen", "127.0.0.1:0", "--grace", "100"});
  const auto stub = connect(process);
  grpc::ClientContext context;
  const auto stream = stub->EditStream(&context);
  begin(*stream, 500000);
  process.signal(SIGTERM);
  ASSERT_TRUE(eventually([&] { return process.log().find("ending on") != std::string::npos; }));
  process.signal(SIGINT);
  EXPECT_EQ(exit_code(process), 128 + SIGINT);
  EXPECT_THAT(process.log(), HasSubstr("ended at once by SIGINT"));
}

TEST_F(LifeOfAProcess, DoesNotEndWithExitZeroWhereAComputationHangs) {
  const auto arguments = [&](const std::string& dumps) {
    return std::vector<std::string>{"--listen", "127.0.0.1:0", "--grace",
                                    "0",        "--dumps",     file(dumps)};
  };
  fs::path dump;  // the first mesh that a computation leaves
  {
    Process process(arguments("dumps"));
    const auto stub = connect(process);
    grpc::ClientContext context;
    const auto stream = stub->EditStream(&context);
    begin(*stream, 5000);
    for (v1::EditStreamResponse reply; stream->Read(&reply) && reply.has_progress();) {
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "dumps"))
      if (entry.path().extension() == ".vtu" && (dump.empty() || entry.path() < dump))
        dump = entry.path();
    ASSERT_FALSE(dump.empty());
  }
  const fs::path fifo = folder_ / "hangs" / fs::relative(dump, folder_ / "dumps");
  fs::create_directories(fifo.parent_path());
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const Descriptor reader(::open(fifo.c_str(), O_RDONLY | O_NONBLOCK));  // which never reads
  Process process(arguments("hangs"));
  const auto stub = connect(process);
  grpc::ClientContext context;
  const auto stream = stub->EditStream(&context);
  begin(*stream, 5000);
  ASSERT_TRUE(eventually([&] {
    int bytes = 0;
    return ::ioctl(reader.get(), FIONREAD, &bytes) == 0 && bytes > 50000;  // of 65,536
  }));
  process.signal(SIGTERM);
  EXPECT_EQ(exit_code(process), 1);
  EXPECT_THAT(process.log(), HasSubstr("does not come to rest"));
}

TEST_F(LifeOfAProcess, EndsOnASignalWhileTheStoreIsBeingOpened) {
  { const Store store(file("store")); }
  fs::remove(file("store/journal.a"));
  // Whose opening waits for a writer.
  ASSERT_EQ(::mkfifo(file("store/journal.a").c_str(), 0600), 0);
  Process process(
      {"--listen", "127.0.0.1:0", "--store", file("store"), "--port-file", file("port")});
  ASSERT_TRUE(eventually([&] { return process.log().find("opening") != std::string::npos; }));
  process.signal(SIGTERM);
  // Else it would wait for ever, as it would if a later version read no FIFO and served.
  EXPECT_TRUE(eventually([&] {
    return process.log().find("ended at once by SIGTERM") != std::string::npos;
  })) << process.log();
  if (HasFailure()) return;
  EXPECT_EQ(exit_code(process), 0);
  EXPECT_FALSE(fs::exists(file("port")));
}

TEST_F(LifeOfAProcess, WritesThePortFileOnceItServes) {
  const std::string socket = "unix:" + file("socket");
  Process process({"--listen", "127.0.0.1:0", "--listen", socket, "--port-file", file("port")});
  ASSERT_TRUE(eventually([&] { return fs::exists(file("port")); })) << process.log();
  EXPECT_EQ(text(file("port")), process.address() + '\n' + socket + '\n');
  EXPECT_EQ(probe_health(process.address(), "liveness", std::chrono::seconds(10)), Health::Serving);
  process.signal(SIGTERM);
  EXPECT_EQ(exit_code(process), 0);
  EXPECT_FALSE(fs::exists(file("port")));
}

TEST_F(LifeOfAProcess, IsToldByHealth) {
  const std::string socket = file("health");
  EXPECT_EQ(health({"--health", "--health-socket", socket}), 2);
  Process process({"--listen", "127.0.0.1:0", "--health-socket", socket, "--grace", "100"});
  const auto stub = connect(process);
  EXPECT_EQ(health({"--health", process.address()}), 0);
  EXPECT_EQ(health({"--health", "unix:" + socket}), 0);
  EXPECT_EQ(health({"--health", "--health-socket", socket}), 0);
  grpc::ClientContext context;
  const auto stream = stub->EditStream(&context);
  begin(*stream, 500000);
  process.signal(SIGTERM);
  ASSERT_TRUE(eventually([&] { return process.log().find("ending on") != std::string::npos; }));
  EXPECT_TRUE(eventually([&] { return health({"--health", "unix:" + socket}) == 1; }));
  EXPECT_EQ(health({"--health", "unix:" + socket, "--live"}), 0);
}

TEST_F(LifeOfAProcess, OpensItsLogAnewOnSighup) {
  const std::string serving = "\"message\":\"serving remesh.v1 on ";
  Process process({"--listen", "127.0.0.1:0", "--log-file", file("log"), "--log-format", "json"});
  ASSERT_TRUE(eventually([&] { return text(file("log")).find(serving) != std::string::npos; }));
  fs::rename(file("log"), file("log.1"));
  process.signal(SIGHUP);
  EXPECT_TRUE(eventually([&] { return text(file("log")).find("SIGHUP") != std::string::npos; }));
  EXPECT_THAT(text(file("log.1")), HasSubstr(serving));
  struct stat status {};
  ASSERT_EQ(::stat(file("log").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(LifeOfAProcess, KeepsItsFilesToItself) {
  Process process({"--listen", "127.0.0.1:0", "--store", file("store")});
  ASSERT_NE(process.address(), "");
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "store"))
    EXPECT_EQ(entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all),
              fs::perms::none)
        << entry.path();
}

}  // namespace
}  // namespace remeshd::test
