#include "server/service/mesh_bytes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/limits.h"
#include "server/service/call.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

v1::MeshMessage part() {
  v1::MeshMessage mesh;
  v1::MeshPart& part = *mesh.mutable_part();
  part.set_array(v1::MESH_ARRAY_TETS);
  part.set_offset(300);
  part.set_crc32c(0xFFFFFFFF);
  return mesh;
}

/// In pieces of at most that many bytes.
PartData data_of(std::size_t bytes, std::size_t piece) {
  const auto text = std::make_shared<std::string>();
  for (std::size_t i = 0; i < bytes; ++i) text->push_back(static_cast<char>(i));
  PartData data{.pieces = {}, .bytes = bytes, .owner = text};
  for (std::size_t at = 0; at < bytes; at += piece)
    data.pieces.push_back(std::string_view(*text).substr(at, piece));
  return data;
}

template <typename Reply>
void expect_read_back(const Reply& reply, const PartData& data = {}) {
  Reply sent = reply, read, wanted = reply;
  for (const std::string_view piece : data.pieces)
    wanted.mutable_mesh()->mutable_part()->mutable_data()->append(piece);
  from_bytes(mesh_bytes(sent, data), 2 * limits::kMeshPartBytes, read);
  EXPECT_EQ(read.SerializeAsString(), wanted.SerializeAsString());
}

TEST(MeshBytes, AreReadBackAsTheReplyOfAnySize) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{100},
                                  std::size_t{127}, std::size_t{16384}, limits::kMeshPartBytes}) {
    v1::GetMeshResponse reply;
    *reply.mutable_mesh() = part();
    expect_read_back(reply, data_of(bytes, 4096));
    v1::EditStreamResponse streamed;
    streamed.set_request_id("edit-7");
    *streamed.mutable_mesh() = part();
    expect_read_back(streamed, data_of(bytes, 4096));
  }
}

TEST(MeshBytes, OfAHeaderAndOfAnEndAreThoseOfTheReply) {
  v1::GetMeshResponse reply;
  reply.mutable_mesh()->mutable_header()->set_revision("abc");
  expect_read_back(reply);
  v1::EditStreamResponse end;
  end.set_request_id("edit-7");
  end.mutable_mesh()->mutable_end()->set_parts(3);
  expect_read_back(end);
}

TEST(MeshBytes, LeaveTheDataWhereTheyLieUntilTheyAreSent) {
  v1::GetMeshResponse reply;
  *reply.mutable_mesh() = part();
  PartData data = data_of(10000, 4096);
  const std::weak_ptr<const void> owner = data.owner;
  std::vector<grpc::Slice> slices;
  {
    const grpc::ByteBuffer bytes = mesh_bytes(reply, data);
    ASSERT_TRUE(bytes.Dump(&slices).ok());
    ASSERT_EQ(slices.size(), 1 + data.pieces.size());
    for (std::size_t i = 0; i < data.pieces.size(); ++i)
      EXPECT_EQ(reinterpret_cast<const char*>(slices[i + 1].begin()), data.pieces[i].data());
    data = {};
  }
  EXPECT_FALSE(owner.expired()) << "slices refer to it";
  slices.clear();
  EXPECT_TRUE(owner.expired());
}

}  // namespace
}  // namespace remeshd
