#pragma once

namespace grpc {
class ServerBuilder;
}

namespace remeshd {

/// ms in which a peer must answer a keepalive ping, or take data that wait for it.
constexpr int kKeepaliveTimeoutMs = 30'000;

/// Calls at a time on one connection; a client's further calls wait at the client.
constexpr int kMostStreams = 256;

/// Sets what a peer may cost before a handler sees anything of it: sizes, streams, pings, time.
void set_transport_limits(grpc::ServerBuilder& builder);

}  // namespace remeshd
