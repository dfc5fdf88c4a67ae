#pragma once

#include <memory>

#include "remesh/v1/remesh.pb.h"
#include "server/service/message_stream.h"
#include "server/session/session.h"

namespace remeshd {

/// Answers a GetMesh: the revision is fetched, then message follows message as the client takes
/// them. For the lane of preparations. Throws Error: what is wrong with the request.
void send_mesh(const std::shared_ptr<MessageStream>& stream, Session& session,
               const remesh::v1::GetMeshRequest& request);

}  // namespace remeshd
