#pragma once

#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>

#include <memory>
#include <string>

namespace remeshd::test {

/// Writes `ca.pem` and, signed by it, `server.cert`, `server.key`, `client.cert`, `client.key`.
void write_keys(const std::string& folder);

/// Of a peer that shows the certificate in such a folder and asks for one of the same authority.
std::shared_ptr<grpc::ServerCredentials> mutual_tls_server(const std::string& folder);
std::shared_ptr<grpc::ChannelCredentials> mutual_tls_client(const std::string& folder);

}  // namespace remeshd::test
