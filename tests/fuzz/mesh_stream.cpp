// What the client library gets from a daemon: messages of a mesh, deltas of arrays, details of
// errors. The first byte chooses which. Checksums are put right here.
#include <grpcpp/support/status.h>

#include <algorithm>
#include <map>

#include "client/formats/read_mesh.h"
#include "client/library/array_delta.h"
#include "client/library/array_digest.h"
#include "client/library/mesh_arrays.h"
#include "client/library/mesh_assembler.h"
#include "client/library/status.h"
#include "proto/checksum.h"
#include "remesh/v1/rpc_status.pb.h"
#include "remeshd/mesh_file.h"
#include "tests/client/mesh_messages.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

namespace v1 = remesh::v1;
using client::Mesh;

// A client has room for what a header announces; a run of this test has not for all of it.
constexpr std::uint64_t kMostRows = 1 << 16;

Mesh small_mesh(double at) {
  return {
      .revision = std::string(64, at == 0 ? 'a' : 'b'),
      .parent = at == 0 ? "" : std::string(64, 'a'),
      .nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {at, 1, 1}},
      .tets = {{0, 1, 2, 3}, {1, 2, 3, 4}},
      .node_ids = {7, 8, 9, 10, 11},
      .tet_ids = {1, 2},
      .facets = {{{0, 2, 1}, 0, 0}, {{0, 1, 3}, 0, 1}, {{1, 2, 4}, 1, 0}},
      .facet_groups = {{"plate.top"}, {"hole.wall", "plate.side"}},
      .tet_cell = {0, 0},
      .cell_owners = {{"plate"}},
      .node_origin = {client::NodeOrigin::Kept, client::NodeOrigin::Kept, client::NodeOrigin::New,
                      client::NodeOrigin::Moved, client::NodeOrigin::New},
      .original_node = {0, 1, -1, 3, -1},
      .node_transform = {0, 0, -1, 0, -1},
      .original_tet = {-1, 1},
      .transforms = {{1, 0, 0, at, 0, 1, 0, 0, 0, 0, 1, 0}},
      .transform_features = {"plate"}};
}

/// CRC-32C of parts, and digests of arrays that are sent whole or are the base's.
void put_checksums_right(std::vector<v1::MeshMessage>& messages, const Mesh& base) {
  std::map<int, std::string> sent;
  for (v1::MeshMessage& message : messages)
    if (message.has_part()) {
      sent[message.part().array()] += message.part().data();
      message.mutable_part()->set_crc32c(crc32c(message.part().data()));
    }
  for (v1::MeshMessage& message : messages) {
    if (!message.has_header()) continue;
    for (auto& entry : *message.mutable_header()->mutable_arrays()) {
      const client::KnownArray* const known = client::find_array(entry.array());
      if (known == nullptr) continue;
      std::string bytes = sent[entry.array()];
      if (entry.encoding() == v1::MeshHeader::ENCODING_SAME) bytes = known->write(base);
      v1::ArrayDelta delta;
      if (entry.encoding() == v1::MeshHeader::ENCODING_DELTA && delta.ParseFromString(bytes)) {
        try {
          bytes = client::apply_delta(delta, known->shape, entry.count(), known->write(base));
        } catch (const client::CallError&) {
          continue;
        }
      }
      entry.set_digest(client::array_digest(bytes));
    }
  }
}

bool has_room(const v1::MeshMessage& message) {
  return !message.has_header() ||
         std::ranges::all_of(message.header().arrays(),
                             [](const auto& entry) { return entry.count() <= kMostRows; });
}

/// A mesh that passed all checks can be written, and its files be read.
void check_files(const Mesh& mesh) {
  using Write = std::string (*)(const Mesh&);
  using Read = client::FileMesh (*)(std::string_view);
  constexpr std::pair<Write, Read> kFormats[] = {{client::to_vtu, client::parse_vtu},
                                                 {client::to_msh, client::parse_msh},
                                                 {client::to_inp, client::parse_inp}};
  for (const auto& [write, read] : kFormats) {
    const client::FileMesh file = read(write(mesh));
    expect(file.tets == mesh.tets, "a mesh file has other tets than the mesh");
  }
}

bool is_complete(const Mesh& mesh) {
  return !mesh.tets.empty() && mesh.node_ids.size() == mesh.nodes.size() &&
         mesh.tet_ids.size() == mesh.tets.size() && mesh.tet_cell.size() == mesh.tets.size();
}

void mesh(std::string_view bytes) {
  static const auto base = std::make_shared<const Mesh>(small_mesh(0));
  Input input(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::vector<v1::MeshMessage> messages;
  while (!input.empty()) {
    v1::MeshMessage message;
    const std::size_t size = input.number(2);
    if (!message.ParseFromString(std::string(input.take(size))) || !has_room(message)) return;
    messages.push_back(std::move(message));
  }
  put_checksums_right(messages, *base);
  client::MeshAssembler assembler({}, {base});
  for (std::size_t k = 0; k < messages.size(); ++k) {
    assembler.add(messages[k]);
    if (k == 1 && messages[0].has_header() && messages[1].has_part()) {
      // A transfer that breaks after its first part goes on with the header once more.
      expect(assembler.resume().has_value(), "nothing to go on with");
      assembler.add(messages[0]);
      std::erase_if(messages, [](const auto& m) { return m.has_end(); });
    }
  }
  if (!assembler.ended()) return;
  const Mesh mesh = assembler.finish();
  if (is_complete(mesh)) check_files(mesh);
}

void delta(std::string_view bytes) {
  Input input(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const auto arrays = client::known_arrays();
  const client::KnownArray& known = arrays[input.byte() % arrays.size()];
  const auto count = static_cast<std::uint32_t>(input.number(2));
  if (known.shape.type == v1::ARRAY_TYPE_TEXT) return;
  v1::ArrayDelta message;
  if (!message.ParseFromString(std::string(input.rest()))) return;
  const std::string made =
      client::apply_delta(message, known.shape, count, known.write(small_mesh(0)));
  expect(made.size() == count * client::row_bytes(known.shape), "a delta of another length");
}

void status(std::string_view bytes) {
  Input input(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const auto code = static_cast<grpc::StatusCode>(input.byte() % 17);
  const v1::Error error =
      client::error_of(grpc::Status(code, "message", std::string(input.rest())));
  error.SerializeAsString();
}

constexpr void (*kKinds[])(std::string_view) = {mesh, delta, status};

std::string framed(const std::vector<v1::MeshMessage>& messages) {
  std::string out;
  for (const v1::MeshMessage& message : messages) {
    const std::string bytes = message.SerializeAsString();
    out += static_cast<char>(bytes.size());
    out += static_cast<char>(bytes.size() >> 8U);
    out += bytes;
  }
  return out;
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_mesh_stream(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  fuzz::Input input(data, size);
  const auto kind = fuzz::kKinds[input.byte() % std::size(fuzz::kKinds)];
  try {
    kind(input.rest());
  } catch (const client::CallError& failure) {
    fuzz::expect(!failure.detail().message().empty(), "an error without a message");
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::mesh_stream_seeds() {
  const Mesh base = small_mesh(0), mesh = small_mesh(1);
  Seeds seeds;
  seeds.push_back('\0' + framed(client::mesh_messages(base)));
  seeds.push_back('\0' + framed(client::mesh_messages(mesh, {.base = &base})));
  seeds.push_back('\0' + framed(client::mesh_messages(mesh, {.part_size = 16, .base = &base})));
  const auto add_delta = [&](int array, std::uint16_t count, const v1::ArrayDelta& message) {
    std::string out = "\1";
    out += static_cast<char>(array);
    out += static_cast<char>(count);
    out += static_cast<char>(count >> 8U);
    seeds.push_back(out + message.SerializeAsString());
  };
  v1::ArrayDelta message;
  message.add_kinds(v1::ArrayDelta::KIND_COPY);
  message.add_counts(3);
  message.add_starts(1);
  add_delta(0, 3, message);
  message.add_kinds(v1::ArrayDelta::KIND_COUNT);
  message.add_counts(5);
  message.add_starts(100);
  add_delta(2, 8, message);
  message.add_kinds(v1::ArrayDelta::KIND_REPEAT);
  message.add_counts(9);
  message.add_starts(0);
  message.set_rows("12345678");
  add_delta(2, 17, message);
  v1::RpcStatus details;
  v1::Error error;
  error.set_reason(v1::Error::BUSY);
  error.set_message("busy");
  auto& any = *details.add_details();
  any.set_type_url("type.googleapis.com/remesh.v1.Error");
  any.set_value(error.SerializeAsString());
  details.set_code(8);
  seeds.push_back(std::string("\2\10") + details.SerializeAsString());
  return seeds;
}
