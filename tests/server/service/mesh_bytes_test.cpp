#include "server/service/mesh_bytes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "server/limits.h"
#include "server/service/call.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

v1::MeshMessage part_of(std::size_t bytes) {
  v1::MeshMessage mesh;
  v1::MeshPart& part = *mesh.mutable_part();
  part.set_array(v1::MESH_ARRAY_TETS);
  part.set_offset(300);
  part.set_crc32c(0xFFFFFFFF);
  for (std::size_t i = 0; i < bytes; ++i) part.mutable_data()->push_back(static_cast<char>(i));
  return mesh;
}

template <typename Reply>
void expect_read_back(const Reply& reply) {
  Reply sent = reply, read;
  from_bytes(mesh_bytes(sent), 2 * limits::kMeshPartBytes, read);
  EXPECT_EQ(read.SerializeAsString(), reply.SerializeAsString());
}

TEST(MeshBytes, AreReadBackAsTheReplyOfAnySize) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{100},
                                  std::size_t{127}, std::size_t{16384}, limits::kMeshPartBytes}) {
    v1::GetMeshResponse reply;
    *reply.mutable_mesh() = part_of(bytes);
    expect_read_back(reply);
    v1::EditStreamResponse streamed;
    streamed.set_request_id("edit-7");
    *streamed.mutable_mesh() = part_of(bytes);
    expect_read_back(streamed);
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

TEST(MeshBytes, LeaveTheDataInOneSliceOfTheirOwn) {
  v1::GetMeshResponse reply;
  *reply.mutable_mesh() = part_of(limits::kMeshPartBytes);
  const char* const data = reply.mesh().part().data().data();
  std::vector<grpc::Slice> slices;
  ASSERT_TRUE(mesh_bytes(reply).Dump(&slices).ok());
  ASSERT_EQ(slices.size(), 2U);
  EXPECT_EQ(reinterpret_cast<const char*>(slices[1].begin()), data) << "copied";
}

}  // namespace
}  // namespace remeshd
