#pragma once

#include <grpcpp/support/byte_buffer.h>

#include "remesh/v1/mesh.pb.h"
#include "remesh/v1/stream.pb.h"
#include "server/service/mesh_messages.h"

namespace remeshd {

/// Serialises a reply that has a message of a mesh. If the message is a part, `data` are the part's
/// bytes: they are handed to gRPC without a copy, for copying would take longer than all other work
/// of a stream; and the mesh in `reply` is cleared.
grpc::ByteBuffer mesh_bytes(remesh::v1::GetMeshResponse& reply, const PartData& data);
grpc::ByteBuffer mesh_bytes(remesh::v1::EditStreamResponse& reply, const PartData& data);

}  // namespace remeshd
