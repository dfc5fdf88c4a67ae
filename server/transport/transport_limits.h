#pragma once

namespace grpc {
class ServerBuilder;
}

namespace remeshd {

/// Sets what a peer may cost before a handler sees anything of it: sizes, streams, pings, time.
void set_transport_limits(grpc::ServerBuilder& builder);

}  // namespace remeshd
