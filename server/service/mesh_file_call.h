#pragma once

#include <memory>

#include "remesh/v1/remesh.pb.h"
#include "server/service/message_stream.h"
#include "server/session/session.h"

namespace remeshd {

/// Answers a GetMeshFile: the revision is fetched, its file made in the lane of computations, then
/// part follows part as the client takes them. For the lane of preparations. Throws Error: what is
/// wrong with the request.
void send_mesh_file(const std::shared_ptr<MessageStream>& stream, Session& session,
                    const remesh::v1::GetMeshFileRequest& request);

}  // namespace remeshd
