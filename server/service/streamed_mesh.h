#pragma once

#include <string>

#include "remesh/v1/mesh.pb.h"
#include "server/service/stream_queue.h"
#include "server/session/session.h"

namespace remeshd {

/// The replies that carry the mesh of the revision that an EditStream's request made; where it
/// cannot be had, an error in its place.
ReplySourcePtr streamed_mesh(Session& session, const Made& made, const std::string& request_id,
                             const remesh::v1::MeshSelection& selection);

}  // namespace remeshd
