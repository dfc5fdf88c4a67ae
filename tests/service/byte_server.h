#pragma once

#include <memory>
#include <string>

namespace grpc {
class Server;
class ServerCredentials;
}  // namespace grpc

namespace remeshd::test {

/// A gRPC server that answers any call by a stream of bytes that mean nothing: what gRPC itself
/// makes of a stream, for comparison.
class ByteServer {
 public:
  /// Each call is answered by so many messages of so many bytes. Listens on a free port of
  /// loopback.
  ByteServer(std::size_t messages, std::size_t bytes,
             const std::shared_ptr<grpc::ServerCredentials>& credentials);
  ~ByteServer();

  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  /// For ever.
  void wait();

 private:
  struct Service;
  std::unique_ptr<Service> service_;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace remeshd::test
