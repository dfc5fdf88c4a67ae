#include "server/process/health_probe.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <memory>

namespace remeshd {
namespace {

// grpc.health.v1, of which gRPC installs no headers: HealthCheckRequest.service is field 1, a text;
// HealthCheckResponse.status is field 1, SERVING is 1.

grpc::ByteBuffer request_for(const std::string& service) {
  const std::string bytes = std::string("\x0a") + static_cast<char>(service.size()) + service;
  const grpc::Slice slice(bytes);
  return {&slice, 1};
}

bool is_serving(const grpc::ByteBuffer& reply) {
  grpc::Slice bytes;
  return reply.DumpToSingleSlice(&bytes).ok() && bytes.size() == 2 && bytes.begin()[0] == 0x08 &&
         bytes.begin()[1] == 0x01;
}

}  // namespace

Health probe_health(const std::string& address, const std::string& service,
                    std::chrono::milliseconds limit) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  grpc::GenericStub stub(
      grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments));
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + limit);
  grpc::CompletionQueue queue;
  const auto call =
      stub.PrepareUnaryCall(&context, "/grpc.health.v1.Health/Check", request_for(service), &queue);
  call->StartCall();
  grpc::ByteBuffer reply;
  grpc::Status status;
  call->Finish(&reply, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  // A service that is not known (NOT_FOUND) is not served either.
  if (status.error_code() == grpc::StatusCode::NOT_FOUND) return Health::NotServing;
  if (!status.ok()) return Health::Unreachable;
  return is_serving(reply) ? Health::Serving : Health::NotServing;
}

}  // namespace remeshd
