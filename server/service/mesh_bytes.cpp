#include "server/service/mesh_bytes.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/wire_format_lite.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "server/service/call.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
namespace wire = google::protobuf::internal;

/// What stands before a field of `size` bytes.
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

/// A slice that owns the string.
grpc::Slice slice_of(std::string text) {
  auto owned = std::make_unique<std::string>(std::move(text));
  grpc::Slice slice(
      owned->data(), owned->size(), [](void* string) { delete static_cast<std::string*>(string); },
      owned.get());
  static_cast<void>(owned.release());
  return slice;
}

/// The fields of the part but its data, then these: readers take fields in any order. `field`: the
/// message's number in the reply.
template <typename Reply>
grpc::ByteBuffer bytes_of(Reply& reply, int field) {
  if (!reply.mesh().has_part()) return to_bytes(reply);
  v1::MeshPart& part = *reply.mutable_mesh()->mutable_part();
  std::string data = std::move(*part.mutable_data());
  part.clear_data();
  std::string head =
      part.SerializeAsString() + field_head(v1::MeshPart::kDataFieldNumber, data.size());
  head = field_head(v1::MeshMessage::kPartFieldNumber, head.size() + data.size()) + head;
  head = field_head(field, head.size() + data.size()) + head;
  reply.clear_mesh();
  head = reply.SerializeAsString() + head;
  const std::array slices{grpc::Slice(head), slice_of(std::move(data))};
  return {slices.data(), slices.size()};
}

}  // namespace

grpc::ByteBuffer mesh_bytes(v1::GetMeshResponse& reply) {
  return bytes_of(reply, v1::GetMeshResponse::kMeshFieldNumber);
}

grpc::ByteBuffer mesh_bytes(v1::EditStreamResponse& reply) {
  return bytes_of(reply, v1::EditStreamResponse::kMeshFieldNumber);
}

}  // namespace remeshd
