#pragma once

#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <chrono>
#include <memory>
#include <string>

#include "tests/client/fake_service.h"

namespace remeshd::client {

/// A FakeService behind a port of this machine.
class FakeDaemon {
 public:
  FakeDaemon() {
    int port = 0;
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
    builder.RegisterService(&service);
    server_ = builder.BuildAndStart();
    address = "127.0.0.1:" + std::to_string(port);
  }
  ~FakeDaemon() {
    // Ends calls that hang.
    server_->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(200));
  }
  FakeDaemon(const FakeDaemon&) = delete;
  FakeDaemon& operator=(const FakeDaemon&) = delete;

  FakeService service;
  std::string address;

 private:
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace remeshd::client
