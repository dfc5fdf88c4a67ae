#pragma once

#include <memory>

#include "remesh/v1/remesh.pb.h"
#include "server/service/call.h"
#include "server/service/message_stream.h"
#include "server/session/session.h"

namespace remeshd {

// The calls of motion.proto: the revision is fetched, what is asked is computed in the lane of
// computations. For the lane of preparations. They throw Error: what is wrong with the request.

/// Part follows part as the client takes them.
void send_velocities(const std::shared_ptr<MessageStream>& stream, Session& session,
                     const remesh::v1::GetDesignVelocitiesRequest& request);

void reply_gradient(const std::shared_ptr<UnaryCall>& call, Session& session,
                    const remesh::v1::GetDesignGradientRequest& request);

void reply_horizons(const std::shared_ptr<UnaryCall>& call, Session& session,
                    const remesh::v1::GetConnectivityHorizonRequest& request);

}  // namespace remeshd
