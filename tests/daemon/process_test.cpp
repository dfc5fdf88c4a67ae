#include "tests/daemon/process.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class EndingProcess : public testing::TestWithParam<int> {};

TEST_P(EndingProcess, EndsAComputationAfterTheGraceTimeAndItselfWithExitZero) {
  Process process({"--listen", "127.0.0.1:0", "--grace", "0.1"});
  const auto stub = connect(process);
  grpc::ClientContext context;
  const auto stream = stub->EditStream(&context);
  v1::EditStreamRequest request;
  *request.mutable_create()->mutable_model() = plate();
  request.mutable_create()->mutable_options()->set_nodes(500000);
  ASSERT_TRUE(stream->Write(request));
  v1::EditStreamResponse reply;
  do ASSERT_TRUE(stream->Read(&reply)) << process.log();
  while (reply.progress().stage() == "queued");
  process.signal(GetParam());
  while (stream->Read(&reply) && reply.has_progress()) {
  }
  EXPECT_EQ(reply.error().code(), v1::Error::CODE_UNAVAILABLE) << reply.ShortDebugString();
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
    v1::CreateRevisionResponse reply;
    const auto status = stub->CreateRevision(&context, request, &reply);
    ASSERT_TRUE(status.ok()) << status.error_message();
    id = reply.result().revision().id();
    process.signal(SIGKILL);
    process.wait();
  }
  Process process({"--listen", "127.0.0.1:0", "--store", folder});
  const auto stub = connect(process);
  grpc::ClientContext context;
  v1::GetRevisionRequest request;
  request.set_revision("plate");
  v1::GetRevisionResponse reply;
  const auto status = stub->GetRevision(&context, request, &reply);
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

TEST(Process, SaysWhereItListensAlsoOnAUnixSocket) {
  const fs::path path =
      fs::temp_directory_path() / ("remeshd-socket-" + std::to_string(::getpid()));
  Process process({"--listen", "unix:" + path.string()});
  EXPECT_EQ(process.address(), "unix:" + path.string());
  EXPECT_EQ(process.log().find("can be reached from elsewhere"), std::string::npos);
  const auto stub = connect(process);
  grpc::ClientContext context;
  v1::GetServerInfoResponse reply;
  EXPECT_TRUE(stub->GetServerInfo(&context, {}, &reply).ok());
  process.signal(SIGTERM);
  process.wait();
  EXPECT_FALSE(fs::exists(path));
}

TEST(Process, EndsBeforeItTouchesTheStoreWhereTheAddressIsNone) {
  const fs::path folder =
      fs::temp_directory_path() / ("remeshd-listen-" + std::to_string(::getpid()));
  for (const char* address : {"0", ":80", "127.0.0.1", "127.0.0.1:99999", "dns:///x", ""}) {
    Process process({"--listen", address, "--store", folder});
    const int status = process.wait();
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), EXIT_FAILURE) << process.log();
    EXPECT_NE(process.log().find(std::string("cannot listen on `") + address + '`'),
              std::string::npos)
        << process.log();
    EXPECT_NE(process.log().find("hint: give HOST:PORT"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder));
  }
}

}  // namespace
}  // namespace remeshd::test
