#include "tests/service/mutual_tls.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/server/guard/certificates.h"

namespace remeshd::test {
namespace {

void write(const std::string& file, const std::string& text) {
  std::ofstream(file) << text;
  std::filesystem::permissions(file, std::filesystem::perms(0600));
}

std::string read(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void write_keys(const std::string& folder) {
  const Authority authority("tests");
  write(folder + "/ca.pem", authority.certificate());
  for (const std::string name : {"server", "client"}) {
    const Issued issued = authority.issue(name);
    write(folder + "/" + name + ".cert", issued.certificate);
    write(folder + "/" + name + ".key", issued.key);
  }
}

std::shared_ptr<grpc::ServerCredentials> mutual_tls_server(const std::string& folder) {
  grpc::SslServerCredentialsOptions options(
      GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  options.pem_root_certs = read(folder + "/ca.pem");
  options.pem_key_cert_pairs.push_back(
      {read(folder + "/server.key"), read(folder + "/server.cert")});
  return grpc::SslServerCredentials(options);
}

std::shared_ptr<grpc::ChannelCredentials> mutual_tls_client(const std::string& folder) {
  return grpc::SslCredentials({.pem_root_certs = read(folder + "/ca.pem"),
                               .pem_private_key = read(folder + "/client.key"),
                               .pem_cert_chain = read(folder + "/client.cert")});
}

}  // namespace remeshd::test
