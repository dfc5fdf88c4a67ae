#pragma once

#include <string>

#include "remesh/v1/mesh.pb.h"
#include "server/service/stream_queue.h"
#include "server/session/session.h"

namespace remeshd {

/// The mesh of what an EditStream's request made, as replies to it; where there is no such mesh,
/// the error that stands in its place.
ReplySourcePtr streamed_mesh(Session& session, const Made& made, const std::string& request_id,
                             const remesh::v1::MeshSelection& selection);

}  // namespace remeshd
