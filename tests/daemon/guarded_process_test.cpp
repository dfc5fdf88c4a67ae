#include "tests/daemon/process.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

int exit_code(Process& process) {
  const int status = process.wait();
  EXPECT_TRUE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

TEST(GuardedProcess, RefusesAnAddressThatOthersReachWithoutMutualTls) {
  Process process({"--listen", "0.0.0.0:0"});
  EXPECT_EQ(exit_code(process), 1);
  EXPECT_THAT(process.log(), HasSubstr("other machines can reach 0.0.0.0:0"));
  Process proxied({"--listen", "0.0.0.0:0", "--behind-proxy", "--check-config"});
  EXPECT_EQ(exit_code(proxied), 0) << proxied.log();
}

TEST(GuardedProcess, RefusesATokenFileThatOthersMayRead) {
  const Folder folder;
  const std::string tokens = folder.file("tokens");
  std::ofstream(tokens) << "anna 0123456789abcdef\n";
  std::filesystem::permissions(tokens, std::filesystem::perms(0644));
  Process process({"--listen", "127.0.0.1:0", "--token-file", tokens});
  EXPECT_EQ(exit_code(process), 1);
  EXPECT_THAT(process.log(), HasSubstr("others may read or change it"));
}

TEST(GuardedProcess, ReadsItsTokensAnewOnSighup) {
  const Folder folder;
  const std::string tokens = folder.file("tokens");
  const auto write = [&](const std::string& text) {
    std::ofstream(tokens) << text;
    std::filesystem::permissions(tokens, std::filesystem::perms(0600));
  };
  write("anna annas-first-token\n");
  Process process({"--listen", "127.0.0.1:0", "--token-file", tokens});
  const auto stub = connect(process);
  const auto call_with = [&](const std::string& token) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token);
    v1::GetServerInfoResponse reply;
    return stub->GetServerInfo(&context, {}, &reply).ok();
  };
  EXPECT_TRUE(call_with("annas-first-token"));
  write("anna annas-second-token\n");
  process.signal(SIGHUP);
  for (int i = 0; i < 1000 && !call_with("annas-second-token"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(call_with("annas-second-token"));
  EXPECT_FALSE(call_with("annas-first-token"));
  EXPECT_THAT(process.log(), testing::Not(HasSubstr("-token\n")));
}

TEST(GuardedProcess, OpensTheStoreOfANewTenantOnSighupAndFindsItAgain) {
  const Folder folder;
  const std::string tokens = folder.file("tokens"), store = folder.file("store");
  const auto write = [&](const std::string& text) {
    std::ofstream(tokens) << text;
    std::filesystem::permissions(tokens, std::filesystem::perms(0600));
  };
  const std::vector<std::string> arguments{"--listen", "127.0.0.1:0", "--token-file",
                                           tokens,     "--store",     store};
  const auto revisions = [](v1::RemeshService::Stub& stub, const std::string& token) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token);
    v1::GetServerInfoResponse reply;
    return stub.GetServerInfo(&context, {}, &reply).ok()
               ? static_cast<int>(reply.server().load().revisions())
               : -1;
  };
  write("anna annas-first-token\n");
  {
    Process process(arguments);
    const auto stub = connect(process);
    EXPECT_EQ(revisions(*stub, "annas-first-token"), 0);
    write("anna annas-first-token\nben bens-first-token\n");
    process.signal(SIGHUP);
    for (int i = 0; i < 1000 && revisions(*stub, "bens-first-token") < 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer bens-first-token");
    v1::CreateRevisionRequest request;
    *request.mutable_model() = plate();
    request.mutable_options()->set_nodes(200);
    v1::CreateRevisionResponse reply;
    const grpc::Status status = stub->CreateRevision(&context, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    EXPECT_EQ(revisions(*stub, "annas-first-token"), 0);
    process.signal(SIGTERM);
    EXPECT_EQ(exit_code(process), 0) << process.log();
  }
  Process process(arguments);
  const auto stub = connect(process);
  EXPECT_EQ(revisions(*stub, "bens-first-token"), 1);
  EXPECT_EQ(revisions(*stub, "annas-first-token"), 0);
}

TEST(GuardedProcess, ServesMetrics) {
  Process process({"--listen", "127.0.0.1:0", "--metrics", "localhost:0"});
  const auto stub = connect(process);
  grpc::ClientContext context;
  v1::GetServerInfoResponse reply;
  ASSERT_TRUE(stub->GetServerInfo(&context, {}, &reply).ok());
  std::smatch port;
  const std::string log = process.log();
  ASSERT_TRUE(std::regex_search(log, port, std::regex("serving metrics on port ([0-9]+)"))) << log;
  std::string text;
  // A call is counted after its client has the answer.
  for (int i = 0; i < 1000 && text.find("GetServerInfo") == std::string::npos; ++i) {
    const Descriptor connection = connect_to("127.0.0.1:" + port[1].str());
    const std::string request = "GET /metrics HTTP/1.0\r\n\r\n";
    ::send(connection.get(), request.data(), request.size(), MSG_NOSIGNAL);
    text.clear();
    char bytes[4096];
    for (ssize_t got = 1; got > 0 && readable(connection);) {
      got = ::recv(connection.get(), bytes, sizeof(bytes), 0);
      if (got > 0) text.append(bytes, static_cast<std::size_t>(got));
    }
  }
  EXPECT_THAT(text, HasSubstr("remeshd_calls_total{code=\"OK\",method=\"GetServerInfo\"} 1"));
  EXPECT_THAT(text, HasSubstr("remeshd_log_dropped_total 0"));
  EXPECT_THAT(text, HasSubstr("remeshd_ready 1"));
}

}  // namespace
}  // namespace remeshd::test
