#pragma once

#include <grpcpp/support/byte_buffer.h>

#include "remesh/v1/mesh.pb.h"
#include "remesh/v1/stream.pb.h"
#include "server/service/mesh_messages.h"

namespace remeshd {

/// Bytes of a reply with a message of a mesh, whose data go to gRPC as they lie in memory: copies
/// take longer than all the rest of a stream. `data`: of its part. Takes the mesh out of the reply.
grpc::ByteBuffer mesh_bytes(remesh::v1::GetMeshResponse& reply, const PartData& data);
grpc::ByteBuffer mesh_bytes(remesh::v1::EditStreamResponse& reply, const PartData& data);

}  // namespace remeshd
