#pragma once

#include <grpcpp/support/byte_buffer.h>

#include "remesh/v1/mesh.pb.h"
#include "remesh/v1/stream.pb.h"
#include "server/service/mesh_messages.h"

namespace remeshd {

/// Serialises a reply that has a message of a mesh. `data`, those of its part, go to gRPC as they
/// lie in memory: copies take longer than all the rest of a stream. Clears the mesh of a reply with
/// a part.
grpc::ByteBuffer mesh_bytes(remesh::v1::GetMeshResponse& reply, const PartData& data);
grpc::ByteBuffer mesh_bytes(remesh::v1::EditStreamResponse& reply, const PartData& data);

}  // namespace remeshd
