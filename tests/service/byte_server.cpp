#include "tests/service/byte_server.h"

#include <grpcpp/generic/async_generic_service.h>
#include <grpcpp/grpcpp.h>

namespace remeshd::test {
namespace {

class Bytes final : public grpc::ServerGenericBidiReactor {
 public:
  Bytes(std::size_t messages, const grpc::ByteBuffer& message)
      : left_(messages), message_(message) {
    write();
  }
  void OnWriteDone(bool ok) override {
    if (ok)
      write();
    else
      Finish(grpc::Status::CANCELLED);
  }
  void OnDone() override { delete this; }

 private:
  void write() {
    if (left_-- > 0)
      StartWrite(&message_);
    else
      Finish(grpc::Status::OK);
  }

  std::size_t left_;
  const grpc::ByteBuffer message_;
};

}  // namespace

struct ByteServer::Service final : grpc::CallbackGenericService {
  Service(std::size_t count, std::size_t bytes) : messages(count) {
    const grpc::Slice slice(std::string(bytes, 'x'));
    message = grpc::ByteBuffer(&slice, 1);
  }
  grpc::ServerGenericBidiReactor* CreateReactor(grpc::GenericCallbackServerContext*) override {
    return new Bytes(messages, message);
  }
  const std::size_t messages;
  grpc::ByteBuffer message;
};

ByteServer::ByteServer(std::size_t messages, std::size_t bytes,
                       const std::shared_ptr<grpc::ServerCredentials>& credentials)
    : service_(std::make_unique<Service>(messages, bytes)) {
  grpc::ServerBuilder builder;
  builder.AddListeningPort("127.0.0.1:0", credentials, &port_);
  builder.RegisterCallbackGenericService(service_.get());
  server_ = builder.BuildAndStart();
}

ByteServer::~ByteServer() = default;

void ByteServer::wait() { server_->Wait(); }

}  // namespace remeshd::test
