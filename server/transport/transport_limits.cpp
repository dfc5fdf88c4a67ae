#include "server/transport/transport_limits.h"

#include <grpcpp/resource_quota.h>
#include <grpcpp/server_builder.h>

#include <cstddef>

namespace remeshd {
namespace {

/// A message of up to 8 MiB is refused in words; gRPC refuses one beyond this itself.
constexpr int kMostReceived = 16 << 20;
/// Of all messages being received together. gRPC 1.51 receives a message whole before it asks for
/// its size, so that this alone bounds messages beyond `kMostReceived`. Where it is reached, gRPC
/// ends streams, and not always those of the connection that is to blame: it must stay out of reach
/// of clients that keep to the rules.
constexpr std::size_t kReceiveMemory = std::size_t{256} << 20;
/// ms until a connection must have said what HTTP/2 begins with.
constexpr int kHandshakeTimeoutMs = 20'000;

/// A kilobyte may be a gigabyte once it is decompressed, and gRPC asks for the size afterwards:
/// what is compressed is refused unread.
void refuse_compression(grpc::ServerBuilder& builder) {
  builder.SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_DEFLATE, false);
  builder.SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_GZIP, false);
  builder.AddChannelArgument(GRPC_ARG_ENABLE_PER_MESSAGE_DECOMPRESSION, 0);
}

void set_keepalive(grpc::ServerBuilder& builder) {
  // The timeout is TCP_USER_TIMEOUT too: shorter, and slow readers that live are cut.
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 60'000);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeoutMs);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  // The client library pings once a second at most. Whoever pings more often than that without
  // being sent anything is disconnected at the ninth such ping.
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 500);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MAX_PING_STRIKES, 8);
}

}  // namespace

void set_transport_limits(grpc::ServerBuilder& builder) {
  refuse_compression(builder);
  set_keepalive(builder);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, kMostStreams);
  builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, kHandshakeTimeoutMs);
  builder.SetMaxReceiveMessageSize(kMostReceived);
  grpc::ResourceQuota quota("remeshd");
  quota.Resize(kReceiveMemory);
  builder.SetResourceQuota(quota);
}

}  // namespace remeshd
