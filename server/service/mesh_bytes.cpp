#include "server/service/mesh_bytes.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/wire_format_lite.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/service/call.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
namespace wire = google::protobuf::internal;

/// Tag and length of a field of `size` bytes.
std::string field_head(int number, std::size_t size) {
  std::string head;
  {
    google::protobuf::io::StringOutputStream stream(&head);
    google::protobuf::io::CodedOutputStream coded(&stream);
    wire::WireFormatLite::WriteTag(number, wire::WireFormatLite::WIRETYPE_LENGTH_DELIMITED, &coded);
    coded.WriteVarint64(size);
  }
  return head;
}

/// A slice of bytes that are not copied; it keeps their owner alive.
grpc::Slice slice_of(std::string_view bytes, const std::shared_ptr<const void>& owner) {
  using Owner = std::shared_ptr<const void>;
  auto kept = std::make_unique<Owner>(owner);
  // gRPC does not write into slices that it sends, though its parameter does not say so.
  grpc::Slice slice(
      const_cast<char*>(bytes.data()), bytes.size(),
      [](void* pointer) { delete static_cast<Owner*>(pointer); }, kept.get());
  static_cast<void>(kept.release());
  return slice;
}

/// Writes the other fields of the part before its data: readers of protobuf take fields in any
/// order. `field`: number of the mesh message's field in the reply.
template <typename Reply>
grpc::ByteBuffer bytes_of(Reply& reply, int field, const PartData& data) {
  if (!reply.mesh().has_part()) return to_bytes(reply);
  std::string head = reply.mesh().part().SerializeAsString() +
                     field_head(v1::MeshPart::kDataFieldNumber, data.bytes);
  head = field_head(v1::MeshMessage::kPartFieldNumber, head.size() + data.bytes) + head;
  head = field_head(field, head.size() + data.bytes) + head;
  reply.clear_mesh();
  head = reply.SerializeAsString() + head;
  std::vector<grpc::Slice> slices;
  slices.reserve(1 + data.pieces.size());
  slices.emplace_back(head);
  for (const std::string_view piece : data.pieces) slices.push_back(slice_of(piece, data.owner));
  return {slices.data(), slices.size()};
}

}  // namespace

grpc::ByteBuffer mesh_bytes(v1::GetMeshResponse& reply, const PartData& data) {
  return bytes_of(reply, v1::GetMeshResponse::kMeshFieldNumber, data);
}

grpc::ByteBuffer mesh_bytes(v1::EditStreamResponse& reply, const PartData& data) {
  return bytes_of(reply, v1::EditStreamResponse::kMeshFieldNumber, data);
}

}  // namespace remeshd
