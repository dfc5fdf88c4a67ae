// SPDX-License-Identifier: Apache-2.0
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <algorithm>
#include <utility>

#include "client/library/client_impl.h"
#include "remeshd/client.h"

namespace remeshd::client {
namespace {

/// Lists and models are the largest single messages; meshes come in parts of at most 1 MiB.
constexpr int kMaxMessage = 256 << 20;
/// ms; also TCP_USER_TIMEOUT, which at 1 s cuts slow but live readers.
constexpr int kKeepaliveTimeout = 20'000;
/// ms between attempts to connect to a daemon that is being restarted: the first, the most.
constexpr int kReconnect = 200, kMostReconnect = 2'000;

bool encrypts(const ConnectOptions& options) {
  return !options.root_certificates.empty() || !options.certificate.empty();
}

std::shared_ptr<grpc::ChannelCredentials> credentials(const ConnectOptions& options) {
  if (!encrypts(options)) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions tls;
  tls.pem_root_certs = options.root_certificates;
  tls.pem_cert_chain = options.certificate;
  tls.pem_private_key = options.private_key;
  return grpc::SslCredentials(tls);
}

/// Whether an address is one of this machine, for which gRPC would use a proxy of the environment
/// too.
bool is_loopback(const std::string& address) {
  return address.starts_with("127.") || address.starts_with("localhost:") ||
         address.starts_with("[::1]:");
}

/// A token is as good as a password: it goes where nobody can read it on its way.
void check_token(const std::string& address, const ConnectOptions& options) {
  if (options.token.empty() || encrypts(options)) return;
  if (is_loopback(address) || address.starts_with("unix:")) return;
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_INVALID_ARGUMENT);
  error.set_stage("request");
  error.set_parameter("token");
  error.set_message("a token would be sent to " + address + " for anyone to read");
  error.set_hint("use TLS: root_certificates; of `remesh`: --tls-ca FILE");
  throw CallError(std::move(error));
}

std::shared_ptr<grpc::Channel> channel_to(const std::string& address,
                                          const ConnectOptions& options) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, options.keepalive * 1000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeout);
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, kReconnect);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, kReconnect);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, kMostReconnect);
  arguments.SetMaxReceiveMessageSize(kMaxMessage);
  if (is_loopback(address)) arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  return grpc::CreateCustomChannel(address, credentials(options), arguments);
}

/// The parts between commas.
std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char c : list) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") + 1 - first);
}

}  // namespace

void refuse_addresses(const std::string& message, const std::string& hint) {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_INVALID_ARGUMENT);
  error.set_stage("request");
  error.set_parameter("address");
  error.set_message(message);
  error.set_hint(hint);
  throw CallError(std::move(error));
}

Client Client::connect(const std::string& addresses, const ConnectOptions& options) {
  return connect_any(split(addresses), options);
}

Client Client::connect_any(const std::vector<std::string>& addresses,
                           const ConnectOptions& options) {
  std::vector<std::unique_ptr<Replica>> replicas;
  for (const std::string& each : addresses) {
    const std::string address = trimmed(each);
    if (address.empty() ||
        std::ranges::find(replicas, address, &Replica::address) != replicas.end())
      continue;
    check_token(address, options);
    replicas.push_back(
        std::make_unique<Replica>(address, channel_to(address, options), options.token));
  }
  if (replicas.empty()) refuse_addresses("no address is given", "give HOST:PORT or unix:PATH");
  return Client(std::make_shared<const Impl>(std::move(replicas)));
}

Client::Client(std::shared_ptr<grpc::Channel> channel) {
  std::vector<std::unique_ptr<Replica>> replicas;
  replicas.push_back(std::make_unique<Replica>("", std::move(channel), ""));
  impl_ = std::make_shared<const Impl>(std::move(replicas));
}

}  // namespace remeshd::client
