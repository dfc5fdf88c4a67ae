#include "server/guard/tls_files.h"

#include <grpcpp/security/server_credentials.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "server/guard/secret_file.h"

namespace remeshd {
namespace {

constexpr unsigned kLookEvery = 5;  // s

template <auto Free>
struct Freed {
  template <typename T>
  void operator()(T* object) const {
    Free(object);
  }
};
using Bio = std::unique_ptr<BIO, Freed<BIO_free_all>>;
using Certificate = std::unique_ptr<X509, Freed<X509_free>>;
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;

/// Reads a certificate file, which need not be secret.
std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw SecretFileError(file.string() + ": " + std::strerror(errno));
  return text;
}

Bio bio_of(const std::string& text) {
  return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

Certificate first_certificate(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  Certificate certificate(PEM_read_bio_X509(bio_of(text).get(), nullptr, nullptr, nullptr));
  if (!certificate) throw SecretFileError(file.string() + ": holds no certificate in PEM");
  return certificate;
}

Key read_key(const std::filesystem::path& file) {
  const std::string text = read_secret_file(file);
  // Without a callback OpenSSL would ask for a password on the terminal.
  const auto no_password = [](char*, int, int, void*) { return 0; };
  Key key(PEM_read_bio_PrivateKey(bio_of(text).get(), nullptr, no_password, nullptr));
  if (!key)
    throw SecretFileError(file.string() + ": holds no private key in PEM, or one with a password");
  return key;
}

}  // namespace

void check_tls_files(const TlsFiles& files) {
  if (!files.used()) return;
  if (files.certificate.empty()) throw SecretFileError("tls-cert: is missing");
  if (files.key.empty()) throw SecretFileError("tls-key: is missing");
  const Certificate certificate = first_certificate(files.certificate);
  if (X509_check_private_key(certificate.get(), read_key(files.key).get()) != 1)
    throw SecretFileError(files.key.string() + ": is not the key of the certificate " +
                          files.certificate.string());
  if (files.mutual()) first_certificate(files.client_ca);
}

std::shared_ptr<grpc::ServerCredentials> make_tls_credentials(const TlsFiles& files) {
  check_tls_files(files);
  namespace tls = grpc::experimental;
  tls::TlsServerCredentialsOptions options(std::make_shared<tls::FileWatcherCertificateProvider>(
      files.key.string(), files.certificate.string(), files.client_ca.string(), kLookEvery));
  options.watch_identity_key_cert_pairs();
  if (files.mutual()) {
    options.watch_root_certs();
    options.set_cert_request_type(GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  } else {
    options.set_cert_request_type(GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE);
  }
  return tls::TlsServerCredentials(options);
}

}  // namespace remeshd
