#include <fstream>

#include "server/guard/secret_file.h"
#include "tests/server/daemon_fixture.h"
#include "tests/server/guard/certificates.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

/// A daemon with certificates of `ca_`, and its files.
class TlsDaemons : public DaemonTest {
 protected:
  void SetUp() override {
    put("ca.pem", ca_.certificate());
    put(ca_.issue("remeshd"));
    options_.tls = {folder_of_files_.file("cert.pem"), folder_of_files_.file("key.pem"),
                    folder_of_files_.file("ca.pem")};
  }
  /// Writes a file in one step, its owner's alone.
  void put(const std::string& name, const std::string& text) const {
    const std::string path = folder_of_files_.file(name);
    std::ofstream(path + ".new") << text;
    std::filesystem::permissions(path + ".new", std::filesystem::perms(0600));
    std::filesystem::rename(path + ".new", path);
  }
  void put(const Issued& own) const {
    put("cert.pem", own.certificate);
    put("key.pem", own.key);
  }
  void serve() { daemon_ = std::make_unique<Daemon>(options_, make_engine()); }

  /// Credentials of a client that trusts `roots` and shows `own`.
  static std::shared_ptr<grpc::ChannelCredentials> credentials(const std::string& roots,
                                                               const Issued& own = {}) {
    return grpc::SslCredentials({roots, own.key, own.certificate});
  }
  /// The code of a call over a connection of its own.
  grpc::StatusCode call_with(const std::shared_ptr<grpc::ChannelCredentials>& credentials,
                             const std::string& address = {}) const {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    const auto stub = v1::RemeshService::NewStub(grpc::CreateCustomChannel(
        address.empty() ? daemon_->address() : address, credentials, arguments));
    grpc::ClientContext context;
    v1::GetServerInfoResponse reply;
    return stub->GetServerInfo(&context, {}, &reply).error_code();
  }

  static constexpr auto kRefused = grpc::StatusCode::UNAVAILABLE;
  const Authority ca_{"ours"}, stranger_{"theirs"};
  const Folder folder_of_files_;
};

TEST_F(TlsDaemons, ServeAClientWithACertificate) {
  serve();
  EXPECT_EQ(call_with(credentials(ca_.certificate(), ca_.issue("client"))), grpc::StatusCode::OK);
}

TEST_F(TlsDaemons, RefuseWhoeverDoesNotEncrypt) {
  serve();
  EXPECT_EQ(call_with(grpc::InsecureChannelCredentials()), kRefused);
}

TEST_F(TlsDaemons, RefuseAClientWithoutACertificate) {
  serve();
  EXPECT_EQ(call_with(credentials(ca_.certificate())), kRefused);
}

TEST_F(TlsDaemons, RefuseACertificateOfAnotherAuthority) {
  serve();
  EXPECT_EQ(call_with(credentials(ca_.certificate(), stranger_.issue("client"))), kRefused);
}

TEST_F(TlsDaemons, RefuseACertificateThatHasExpired) {
  serve();
  EXPECT_EQ(call_with(credentials(ca_.certificate(), ca_.issue("client", -60))), kRefused);
}

TEST_F(TlsDaemons, ShowTheirOwnCertificate) {
  serve();
  EXPECT_EQ(call_with(credentials(stranger_.certificate(), ca_.issue("client"))), kRefused);
}

TEST_F(TlsDaemons, AskClientsForNoCertificateWithoutAnAuthorityOfTheirs) {
  options_.tls.client_ca.clear();
  serve();
  EXPECT_EQ(call_with(credentials(ca_.certificate())), grpc::StatusCode::OK);
  EXPECT_EQ(call_with(grpc::InsecureChannelCredentials()), kRefused);
}

TEST_F(TlsDaemons, AreReachedOverAUnixSocketWithoutCertificates) {
  const std::string socket = "unix:" + folder_of_files_.file("socket");
  options_.listen.push_back(socket);
  serve();
  EXPECT_EQ(call_with(grpc::InsecureChannelCredentials(), socket), grpc::StatusCode::OK);
  EXPECT_EQ(call_with(grpc::InsecureChannelCredentials()), kRefused);
}

TEST_F(TlsDaemons, TakeNewCertificatesFromTheirFiles) {
  serve();
  put(stranger_.issue("remeshd"));
  put("ca.pem", stranger_.certificate());
  const auto fresh = credentials(stranger_.certificate(), stranger_.issue("client"));
  grpc::StatusCode code = kRefused;
  for (int i = 0; i < 200 && code != grpc::StatusCode::OK; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    code = call_with(fresh);
  }
  EXPECT_EQ(code, grpc::StatusCode::OK);
  EXPECT_EQ(call_with(credentials(stranger_.certificate(), ca_.issue("client"))), kRefused);
}

TEST_F(TlsDaemons, DoNotStartWithFilesThatDoNotFit) {
  const auto complaint = [&] {
    try {
      serve();
    } catch (const SecretFileError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  using testing::HasSubstr;
  put("key.pem", ca_.issue("another").key);
  EXPECT_THAT(complaint(), HasSubstr("is not the key of the certificate"));
  put("key.pem", "no key");
  EXPECT_THAT(complaint(), HasSubstr("key.pem: holds no private key"));
  std::filesystem::permissions(options_.tls.key, std::filesystem::perms(0644));
  EXPECT_THAT(complaint(), HasSubstr("key.pem: others may read"));
  options_.tls.key.clear();
  EXPECT_THAT(complaint(), HasSubstr("tls-key: is missing"));
  put(ca_.issue("remeshd"));
  options_.tls.key = folder_of_files_.file("key.pem");
  put("ca.pem", "");
  EXPECT_THAT(complaint(), HasSubstr("ca.pem: holds no certificate"));
}

}  // namespace
}  // namespace remeshd::test
