#include "tests/service/byte_server.h"

#include <grpcpp/generic/async_generic_service.h>
#include <grpcpp/grpcpp.h>

#include <vector>

namespace remeshd::test {
namespace {

class Bytes final : public grpc::ServerGenericBidiReactor {
 public:
  Bytes(const std::vector<grpc::ByteBuffer>& messages) : messages_(messages) { write(); }
  void OnWriteDone(bool ok) override {
    if (ok)
      write();
    else
      Finish(grpc::Status::CANCELLED);
  }
  void OnDone() override { delete this; }

 private:
  void write() {
    if (next_ < messages_.size())
      StartWrite(&messages_[next_++]);
    else
      Finish(grpc::Status::OK);
  }

  std::size_t next_ = 0;
  std::vector<grpc::ByteBuffer> messages_;
};

}  // namespace

struct ByteServer::Service final : grpc::CallbackGenericService {
  Service(std::size_t count, std::size_t bytes) {
    for (std::size_t i = 0; i < count; ++i) {
      const grpc::Slice slice(std::string(bytes, 'x'));
      messages.emplace_back(&slice, 1);
    }
  }
  grpc::ServerGenericBidiReactor* CreateReactor(grpc::GenericCallbackServerContext*) override {
    return new Bytes(messages);
  }
  std::vector<grpc::ByteBuffer> messages;
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
