#pragma once

#include <filesystem>
#include <memory>

namespace grpc {
class ServerCredentials;
}

namespace remeshd {

/// PEM files of a server.
struct TlsFiles {
  std::filesystem::path certificate;  ///< its own, with the chain behind it; empty: no TLS
  std::filesystem::path key;          ///< of the certificate
  std::filesystem::path client_ca;  ///< CAs of the clients' certificates; empty: clients need none

  [[nodiscard]] bool used() const {
    return !certificate.empty() || !key.empty() || !client_ca.empty();
  }
  /// Whether clients have to show who they are.
  [[nodiscard]] bool mutual() const { return !client_ca.empty(); }
};

/// Throws SecretFileError: certificate or key is missing, a file cannot be read or does not hold
/// what it should, others may read the key, the key is not that of the certificate.
void check_tls_files(const TlsFiles& files);

/// Credentials that take new certificates from the files within 10 s: key and certificate should
/// be replaced together, by the rename of a folder or of a link to one. Connections that exist
/// stay. Throws what `check_tls_files` throws.
std::shared_ptr<grpc::ServerCredentials> make_tls_credentials(const TlsFiles& files);

}  // namespace remeshd
