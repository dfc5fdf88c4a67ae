#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "client/cli/connect_options.h"
#include "client/cli/exit_code.h"
#include "server/daemon.h"
#include "server/guard/doorman.h"
#include "tests/server/guard/certificates.h"
#include "tests/support/temporary_folder.h"

namespace remeshd::cli {
namespace {

using test::Authority;
using test::Issued;
using testing::HasSubstr;

/// A daemon that asks for certificates and tokens, and the files of one who may call it.
class SecureConnection : public testing::Test {
 protected:
  void SetUp() override {
    put("ca.pem", ca_.certificate());
    put("server", ca_.issue("remeshd"));
    put("client", ca_.issue("client"));
    put("tokens", "anna anna-s-secret-token\n");
    put("token", "anna-s-secret-token\n");
    options_.listen = {"127.0.0.1:0"};
    options_.tls = {file("server.cert"), file("server.key"), file("ca.pem")};
    options_.doorman = std::make_shared<Doorman>(file("tokens"));
    daemon_ = std::make_unique<Daemon>(options_, production_engine());
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    std::filesystem::permissions(file(name), std::filesystem::perms(0600));
  }
  void put(const std::string& name, const Issued& issued) const {
    put(name + ".cert", issued.certificate);
    put(name + ".key", issued.key);
  }
  int info(std::vector<std::string> options) {
    options.insert(options.begin(), {"--timeout", "20", "--address", daemon_->address()});
    options.emplace_back("info");
    std::istringstream in;
    std::ostringstream out;
    err_.str("");
    return run(options, {.in = in,
                         .out = out,
                         .err = err_,
                         .terminal = false,
                         .stop = {},
                         .connect = [](const GlobalOptions& given) {
                           return client::Client::connect(given.address, connect_options(given));
                         }});
  }
  [[nodiscard]] std::vector<std::string> all() const {
    return {"--tls-ca",  file("ca.pem"),     "--tls-cert",   file("client.cert"),
            "--tls-key", file("client.key"), "--token-file", file("token")};
  }

  const Authority ca_{"ours"}, stranger_{"theirs"};
  const TemporaryFolder folder_;
  DaemonOptions options_;
  std::unique_ptr<Daemon> daemon_;
  std::ostringstream err_;
};

TEST_F(SecureConnection, IsMadeWithCertificateAndToken) {
  EXPECT_EQ(info(all()), kFine) << err_.str();
}

TEST_F(SecureConnection, IsNotMadeInTheClear) { EXPECT_EQ(info({}), kUnreachable); }

TEST_F(SecureConnection, IsNotMadeWithoutOrWithAForeignCertificate) {
  EXPECT_EQ(info({"--tls-ca", file("ca.pem"), "--token-file", file("token")}), kUnreachable);
  put("client", stranger_.issue("client"));
  EXPECT_EQ(info(all()), kUnreachable);
}

TEST_F(SecureConnection, IsNotMadeToADaemonOfAnotherAuthority) {
  put("ca.pem", stranger_.certificate());
  EXPECT_EQ(info(all()), kUnreachable);
}

TEST_F(SecureConnection, IsDeniedWithoutTheRightToken) {
  std::vector<std::string> without = all();
  without.resize(6);
  EXPECT_EQ(info(without), kDenied);
  put("token", "another-token-of-some");
  EXPECT_EQ(info(all()), kDenied);
  EXPECT_THAT(err_.str(), testing::Not(HasSubstr("another-token")));
}

TEST_F(SecureConnection, TellsWhatIsWrongWithItsFiles) {
  EXPECT_EQ(info({"--tls-ca", file("none")}), kFileFailed);
  EXPECT_THAT(err_.str(), HasSubstr("none: cannot be read"));
  EXPECT_EQ(info({"--tls-cert", file("client.cert")}), kUsage);
  put("token", "anna anna-s-secret-token");
  EXPECT_EQ(info(all()), kFileFailed);
  EXPECT_THAT(err_.str(), HasSubstr("one token"));
}

TEST(Tokens, AreNotSentWhereOthersCouldReadThem) {
  client::ConnectOptions options;
  options.token = "anna-s-secret-token";
  EXPECT_THROW(client::Client::connect("mesh.example:50051", options), client::CallError);
  EXPECT_NO_THROW(client::Client::connect("127.0.0.1:50051", options));
  EXPECT_NO_THROW(client::Client::connect("unix:/socket", options));
  options.root_certificates = Authority("ours").certificate();
  EXPECT_NO_THROW(client::Client::connect("mesh.example:50051", options));
}

}  // namespace
}  // namespace remeshd::cli
