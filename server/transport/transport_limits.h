#pragma once

namespace grpc {
class ServerBuilder;
}

namespace remeshd {

/// ms in which a peer must answer a keepalive ping, or take data that wait for it.
constexpr int kKeepaliveTimeoutMs = 30'000;

/// Sets what a peer may cost before a handler sees anything of it: sizes, streams, pings, time.
void set_transport_limits(grpc::ServerBuilder& builder);

}  // namespace remeshd
