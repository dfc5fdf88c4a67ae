#include <chrono>
#include <cstring>
#include <thread>

#include "proto/checksum.h"
#include "server/limits.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

class Mesh : public DaemonTest {
 protected:
  /// How a transfer ends.
  grpc::Status mesh_status(const v1::GetMeshRequest& request) {
    grpc::ClientContext context;
    v1::GetMeshResponse message;
    const auto reader = stub().GetMesh(&context, request);
    while (reader->Read(&message)) continue;
    return reader->Finish();
  }
};

v1::GetMeshRequest all_of(const std::string& revision) {
  v1::GetMeshRequest request;
  request.set_revision(revision);
  return request;
}

/// SHA-256 over the SHA-256s of blocks of 16 KiB, as mesh.proto has it.
std::string block_digest(const std::string& data) {
  Sha256 whole;
  for (std::size_t at = 0; at < data.size(); at += 16384) {
    Sha256 block;
    block.update(std::string_view(data).substr(at, 16384));
    whole.update(block.finish());
  }
  return to_hex(whole.finish());
}

/// The arrays of a stream by name, put together from its parts, which are checked on the way.
std::map<v1::MeshArray, std::string> assemble(const std::vector<v1::MeshMessage>& messages) {
  std::map<v1::MeshArray, std::string> arrays;
  std::uint64_t bytes = 0;
  std::uint32_t parts = 0;
  EXPECT_TRUE(messages.front().has_header());
  EXPECT_TRUE(messages.back().has_end());
  for (const v1::MeshMessage& message : messages) {
    EXPECT_LE(message.ByteSizeLong(), std::size_t{1} << 20);
    if (!message.has_part()) continue;
    const v1::MeshPart& part = message.part();
    EXPECT_EQ(part.offset(), arrays[part.array()].size());
    EXPECT_EQ(part.crc32c(), crc32c(part.data()));
    arrays[part.array()] += part.data();
    bytes += part.data().size();
    ++parts;
  }
  EXPECT_EQ(messages.back().end().bytes(), bytes);
  EXPECT_EQ(messages.back().end().parts(), parts);
  for (const auto& array : messages.front().header().arrays()) {
    const std::string& data = arrays[array.array()];
    EXPECT_EQ(data.size(), array.bytes()) << array.array();
    EXPECT_EQ(array.data_bytes(), array.bytes());
    EXPECT_EQ(array.encoding(), v1::MeshHeader::ENCODING_WHOLE);
    EXPECT_EQ(array.digest(), block_digest(data)) << array.array();
  }
  return arrays;
}

template <typename T>
std::vector<T> values(const std::string& bytes) {
  std::vector<T> out(bytes.size() / sizeof(T));
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

TEST_F(Mesh, TakesMemoryUntilItsClientHasIt) {
  create(create_request(plate(), 1000000));
  const auto taken = [this] { return info().load().memory_bytes(); };
  std::uint64_t before = 0;
  while (before != taken()) {  // the job gives its share back a moment after the reply
    before = taken();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  grpc::ClientContext context;
  const auto reader = stub().GetMesh(&context, all_of("plate"));
  v1::GetMeshResponse message;
  ASSERT_TRUE(reader->Read(&message));
  EXPECT_GE(taken(), before + limits::kUntakenBytes);
  context.TryCancel();
  reader->Finish();
}

TEST_F(Mesh, ComesAsHeaderPartsAndEndWithEveryArray) {
  create(plate());
  const auto child = edit("plate", set("at", 11));
  const auto messages = mesh(all_of("plate"));
  const auto& header = messages.front().header();
  EXPECT_EQ(header.revision(), child.revision().id());
  EXPECT_EQ(header.parent(), child.revision().parent());
  EXPECT_EQ(header.nodes(), 100U);
  EXPECT_EQ(header.tets(), 97U);
  EXPECT_EQ(header.facets(), 2U);

  auto arrays = assemble(messages);
  EXPECT_EQ(arrays.size(), 16U);
  EXPECT_EQ(values<double>(arrays[v1::MESH_ARRAY_NODES]).size(), 300U);
  EXPECT_EQ(values<std::int32_t>(arrays[v1::MESH_ARRAY_TETS])[5], 2);  // second tet: 1 2 3 4
  EXPECT_EQ(values<std::uint64_t>(arrays[v1::MESH_ARRAY_NODE_IDS])[7], 1007U);
  EXPECT_EQ(values<std::int32_t>(arrays[v1::MESH_ARRAY_FACETS]),
            (std::vector<std::int32_t>{0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(values<std::int32_t>(arrays[v1::MESH_ARRAY_FACET_TETS]),
            (std::vector<std::int32_t>{0, 0}));
  EXPECT_EQ(values<std::int32_t>(arrays[v1::MESH_ARRAY_FACET_GROUP]),
            (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(arrays[v1::MESH_ARRAY_FACET_GROUPS], "plate.top\nhole.wall plate.top\n");
  EXPECT_EQ(arrays[v1::MESH_ARRAY_CELL_OWNERS], "plate hole\n");
  EXPECT_EQ(arrays[v1::MESH_ARRAY_NODE_ORIGINS].substr(0, 4), std::string("\1\0\1\0", 4));
  EXPECT_EQ(values<std::int32_t>(arrays[v1::MESH_ARRAY_ORIGINAL_NODES])[1], -1);
  const auto transforms = values<double>(arrays[v1::MESH_ARRAY_TRANSFORMS]);
  ASSERT_EQ(transforms.size(), 24U);
  EXPECT_EQ(transforms[23], 3);  // the third row's translation of the second one
  EXPECT_EQ(arrays[v1::MESH_ARRAY_TRANSFORM_FEATURES], "plate\nrib\n");
}

TEST_F(Mesh, LargerThanAMessageComesInSeveralParts) {
  create(create_request(plate(), 200000));
  const auto messages = mesh(all_of("plate"));
  auto arrays = assemble(messages);
  EXPECT_EQ(arrays[v1::MESH_ARRAY_NODES].size(), 200000U * 24);
  EXPECT_GT(messages.size(), 15U);
}

TEST_F(Mesh, ComesInTheArraysAskedForAlone) {
  create(plate());
  auto request = all_of("plate");
  request.mutable_selection()->add_arrays(v1::MESH_ARRAY_TETS);
  request.mutable_selection()->add_arrays(v1::MESH_ARRAY_NODES);
  const auto arrays = assemble(mesh(request));
  EXPECT_EQ(arrays.size(), 2U);
}

TEST_F(Mesh, IsTheSameBytesEveryTime) {
  create(plate());
  EXPECT_EQ(mesh_bytes("plate"), mesh_bytes("plate@1"));
}

TEST_F(Mesh, OfAnUnknownRevisionOrArrayIsAnError) {
  create(plate());
  auto request = all_of("plank");
  grpc::ClientContext first;
  v1::GetMeshResponse message;
  auto reader = stub().GetMesh(&first, request);
  EXPECT_FALSE(reader->Read(&message));
  EXPECT_EQ(detail(reader->Finish()).reason(), v1::Error::REVISION_NOT_FOUND);

  request.set_revision("plate");
  request.mutable_selection()->add_arrays(static_cast<v1::MeshArray>(99));
  grpc::ClientContext second;
  reader = stub().GetMesh(&second, request);
  EXPECT_FALSE(reader->Read(&message));
  EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST_F(Mesh, GoesOnFromAnyPlaceInItsData) {
  create(create_request(plate(), 60000));
  const auto whole = mesh(all_of("plate"));
  const auto arrays = assemble(whole);
  for (const std::uint64_t offset : {0U, 1000000U, 1440000U}) {
    auto request = all_of("plate");
    request.mutable_resume_from()->set_array(v1::MESH_ARRAY_NODES);
    request.mutable_resume_from()->set_offset(offset);
    const auto rest = mesh(request);
    EXPECT_EQ(rest.front().SerializeAsString(), whole.front().SerializeAsString());
    std::string nodes = arrays.at(v1::MESH_ARRAY_NODES).substr(0, offset);
    std::uint64_t bytes = 0;
    for (const v1::MeshMessage& message : rest) {
      bytes += message.part().data().size();
      if (message.part().array() == v1::MESH_ARRAY_NODES) nodes += message.part().data();
    }
    EXPECT_EQ(nodes, arrays.at(v1::MESH_ARRAY_NODES));
    EXPECT_EQ(rest.back().end().bytes(), bytes);
    EXPECT_EQ(bytes + offset, whole.back().end().bytes());
  }
}

TEST_F(Mesh, DoesNotGoOnFromWhereItNeverWas) {
  create(create_request(plate(), 100));
  auto request = all_of("plate");
  request.mutable_resume_from()->set_array(v1::MESH_ARRAY_NODES);
  request.mutable_resume_from()->set_offset(1 << 20);
  EXPECT_EQ(mesh_status(request).error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  request.mutable_resume_from()->set_offset(0);
  request.mutable_selection()->add_arrays(v1::MESH_ARRAY_TETS);
  EXPECT_EQ(mesh_status(request).error_code(), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST_F(Mesh, LeftInTheMiddleDoesNotDisturbTheDaemon) {
  create(create_request(plate(), 500000));
  {
    grpc::ClientContext context;
    auto reader = stub().GetMesh(&context, all_of("plate"));
    v1::GetMeshResponse message;
    ASSERT_TRUE(reader->Read(&message));
    context.TryCancel();
  }
  EXPECT_TRUE(serves());
}

}  // namespace
}  // namespace remeshd::test
