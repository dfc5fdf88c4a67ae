#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>

#include <fstream>
#include <sstream>

#include "remesh/v1/cache.pb.h"
#include "remesh/v1/remesh.pb.h"
#include "server/guard/doorman.h"
#include "server/guard/secret_file.h"
#include "server/process/health_probe.h"
#include "tests/server/daemon_fixture.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

const std::string kToken = "anna-s-secret-token";

class TokenCalls : public DaemonTest {
 protected:
  /// Calls that end write into the log.
  ~TokenCalls() override { stop(); }
  void SetUp() override {
    write("anna " + kToken + "\n");
    options_.doorman = std::make_shared<Doorman>(file());
    options_.log = std::make_shared<spdlog::logger>(
        "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_));
  }
  [[nodiscard]] std::string file() const { return folder_of_file_.file("tokens"); }
  void write(const std::string& text) const {
    std::ofstream(file()) << text;
    std::filesystem::permissions(file(), std::filesystem::perms(0600));
  }
  grpc::Status info_with(const std::string& authorization) {
    grpc::ClientContext context;
    if (!authorization.empty()) context.AddMetadata("authorization", authorization);
    v1::GetServerInfoResponse reply;
    return stub().GetServerInfo(&context, {}, &reply);
  }

  Folder folder_of_file_;
  std::ostringstream log_;
};

TEST_F(TokenCalls, AreAnsweredWithATokenOfTheFile) {
  EXPECT_TRUE(info_with("Bearer " + kToken).ok());
  EXPECT_TRUE(info_with("bearer " + kToken).ok());
}

TEST_F(TokenCalls, AreRefusedWithoutOne) {
  const grpc::Status none = info_with("");
  EXPECT_EQ(none.error_code(), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(detail(none).reason(), v1::Error::CREDENTIALS_MISSING);
  for (const std::string& wrong : {std::string("Bearer another-token-of-some"), "Basic " + kToken,
                                   kToken, "Bearer " + kToken + "x", std::string("Bearer ")}) {
    const grpc::Status status = info_with(wrong);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
    EXPECT_EQ(detail(status).reason(), v1::Error::CREDENTIALS_INVALID);
  }
}

TEST_F(TokenCalls, AreRefusedByEveryMethod) {
  start();
  // Descriptors are linked only where something names them; this file holds services alone.
  const void* volatile services = &descriptor_table_remesh_2fv1_2fremesh_2eproto;
  ASSERT_NE(services, nullptr);
  static_cast<void>(v1::GetCacheStatsRequest::descriptor());
  int methods = 0;
  for (const char* name : {"remesh.v1.RemeshService", "remesh.v1.CacheService"}) {
    const auto* service =
        google::protobuf::DescriptorPool::generated_pool()->FindServiceByName(name);
    ASSERT_NE(service, nullptr);
    for (int i = 0; i < service->method_count(); ++i, ++methods) {
      std::string reply;
      const std::string method = service->method(i)->name();
      EXPECT_EQ(call("/" + std::string(name) + "/" + method, "", &reply).error_code(),
                grpc::StatusCode::UNAUTHENTICATED)
          << method;
    }
  }
  EXPECT_GT(methods, 20);
  EXPECT_EQ(engine_.started(), 0);
}

TEST_F(TokenCalls, OfTheHealthServiceNeedNone) {
  start();
  EXPECT_EQ(probe_health(daemon_->address(), "liveness", std::chrono::seconds(10)),
            Health::Serving);
}

TEST_F(TokenCalls, AreLoggedWithTheTenantAndWithoutTheToken) {
  info_with("Bearer " + kToken);
  info_with("Bearer another-token-of-some");
  stop();
  EXPECT_THAT(log_.str(), testing::HasSubstr(" status=OK tenant=anna"));
  EXPECT_THAT(log_.str(), testing::HasSubstr("reason=CREDENTIALS_INVALID"));
  EXPECT_THAT(log_.str(), testing::Not(testing::HasSubstr("token-of-some")));
  EXPECT_THAT(log_.str(), testing::Not(testing::HasSubstr(kToken)));
}

TEST_F(TokenCalls, FollowTheFileOnceItIsReadAnew) {
  EXPECT_TRUE(info_with("Bearer " + kToken).ok());
  write("anna anna-s-second-token\n");
  EXPECT_TRUE(info_with("Bearer " + kToken).ok());
  options_.doorman->reload();
  EXPECT_FALSE(info_with("Bearer " + kToken).ok());
  EXPECT_TRUE(info_with("Bearer anna-s-second-token").ok());
  write("nonsense\n");
  EXPECT_THROW(options_.doorman->reload(), SecretFileError);
  EXPECT_TRUE(info_with("Bearer anna-s-second-token").ok());
}

}  // namespace
}  // namespace remeshd::test
