#include "client/library/mesh_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "remeshd/error.h"
#include "tests/client/mesh_messages.h"
#include "tests/client/sample_mesh.h"

namespace remeshd::client {
namespace {

using remesh::v1::MeshArray;
using remesh::v1::MeshHeader;
using testing::IsEmpty;
using testing::SizeIs;
using Messages = std::vector<remesh::v1::MeshMessage>;

Mesh assemble(const Messages& messages, const std::vector<MeshArray>& arrays = {},
              const std::shared_ptr<const Mesh>& base = nullptr) {
  MeshAssembler assembler(arrays, {nullptr, base});
  for (const auto& message : messages) assembler.add(message);
  return assembler.finish();
}

/// A mesh of an edit: some nodes moved, one tet more, the rest as in the base.
Mesh edited(Mesh mesh) {
  mesh.parent = mesh.revision;
  mesh.revision = "edited";
  mesh.nodes[3] = {0.5, 0.25, -0.125};
  mesh.nodes.push_back({1, 2, 3});
  mesh.node_ids.push_back(77);
  mesh.node_sizes.push_back(0.5);
  mesh.node_origin.assign(mesh.nodes.size(), NodeOrigin::Kept);
  mesh.node_origin.back() = NodeOrigin::New;
  mesh.node_transform.assign(mesh.nodes.size(), 0);
  mesh.original_node.clear();
  for (std::size_t k = 0; k + 1 < mesh.nodes.size(); ++k)
    mesh.original_node.push_back(static_cast<std::int32_t>(k));
  mesh.original_node.push_back(-1);
  return mesh;
}

std::shared_ptr<const Mesh> base_mesh() {
  Mesh mesh = sample_mesh(2);
  mesh.revision = "base";
  return std::make_shared<const Mesh>(std::move(mesh));
}

TEST(MeshAssembler, PutsTheMeshTogetherWhateverTheSizeOfTheParts) {
  Mesh mesh = sample_mesh(2);
  mesh.revision = "r";
  mesh.parent = "p";
  for (const std::size_t size : {std::size_t{1000}, std::size_t{13}, std::size_t{1} << 20})
    EXPECT_EQ(assemble(mesh_messages(mesh, {.part_size = size})), mesh) << size;
}

TEST(MeshAssembler, RebuildsAMeshFromItsDifferencesToTheBits) {
  const auto base = base_mesh();
  const Mesh mesh = edited(*base);
  const Messages messages = mesh_messages(mesh, {.part_size = 100, .base = base.get()});
  EXPECT_EQ(assemble(messages, {}, base), mesh);
  const std::uint64_t sent = messages.back().end().bytes();
  EXPECT_LT(sent, mesh_messages(mesh).back().end().bytes() / 5);
}

TEST(MeshAssembler, LeavesEmptyWhatWasNotAskedFor) {
  const std::vector<MeshArray> arrays{remesh::v1::MESH_ARRAY_NODES, remesh::v1::MESH_ARRAY_FACETS};
  const Mesh whole = sample_mesh(1);
  const Mesh mesh = assemble(mesh_messages(whole, {.arrays = arrays}), arrays);
  EXPECT_EQ(mesh.nodes, whole.nodes);
  EXPECT_THAT(mesh.tets, IsEmpty());
  ASSERT_THAT(mesh.facets, SizeIs(whole.facets.size()));
  EXPECT_EQ(mesh.facets[1].nodes, whole.facets[1].nodes);
  EXPECT_EQ(mesh.facets[1].tet, -1);
}

TEST(MeshAssembler, TakesAnEvenMeshWhichHasNoSizes) {
  Mesh mesh = sample_mesh(1);
  mesh.node_sizes.clear();
  EXPECT_EQ(assemble(mesh_messages(mesh)), mesh);
}

TEST(MeshAssembler, TakesAMeshOfSecondOrderWholeAndAsDifferences) {
  Mesh mesh = with_mid_nodes(*base_mesh());
  EXPECT_EQ(assemble(mesh_messages(mesh)), mesh);
  const auto base = std::make_shared<const Mesh>(mesh);
  mesh.revision = "edited";
  mesh.mid_nodes[7] = {0.25, -0.5, 0.125};
  mesh.mid_node_origin[7] = NodeOrigin::Moved;
  const Messages messages = mesh_messages(mesh, {.part_size = 100, .base = base.get()});
  EXPECT_EQ(assemble(messages, {}, base), mesh);
}

TEST(MeshAssembler, RefusesAMeshOfSecondOrderWithoutItsMidNodes) {
  const std::vector<MeshArray> some{remesh::v1::MESH_ARRAY_NODES, remesh::v1::MESH_ARRAY_TETS};
  const std::vector<MeshArray> more{remesh::v1::MESH_ARRAY_NODES, remesh::v1::MESH_ARRAY_TETS,
                                    remesh::v1::MESH_ARRAY_TET_MIDS};
  EXPECT_NO_THROW(assemble(mesh_messages(sample_mesh(1), {.arrays = some}), more));
  EXPECT_THROW(assemble(mesh_messages(with_mid_nodes(sample_mesh(1)), {.arrays = some}), more),
               CallError);
}

TEST(MeshAssembler, RefusesMidNodesThatAreNotThere) {
  Mesh mesh = with_mid_nodes(sample_mesh(1));
  mesh.tet_mids[2][4] = static_cast<std::int32_t>(mesh.mid_nodes.size());
  EXPECT_THROW(assemble(mesh_messages(mesh)), CallError);
  mesh = with_mid_nodes(sample_mesh(1));
  mesh.facets[1].mids[0] = -1;
  EXPECT_THROW(assemble(mesh_messages(mesh)), CallError);
}

TEST(MeshAssembler, PassesOverArraysOfANewerProtocol) {
  const Mesh mesh = sample_mesh(1);
  Messages messages = mesh_messages(mesh);
  auto* entry = messages[0].mutable_header()->add_arrays();
  entry->set_array(static_cast<MeshArray>(99));
  entry->set_encoding(static_cast<MeshHeader::Encoding>(9));
  entry->set_data_bytes(3);
  auto& part = *messages.insert(messages.end() - 1, remesh::v1::MeshMessage{})->mutable_part();
  part.set_array(static_cast<MeshArray>(99));
  part.set_data("abc");
  part.set_crc32c(crc32c("abc"));
  messages.back().mutable_end()->set_bytes(messages.back().end().bytes() + 3);
  messages.back().mutable_end()->set_parts(messages.back().end().parts() + 1);
  EXPECT_EQ(assemble(messages), mesh);
}

void expect_damage(const std::function<void()>& call) {
  try {
    call();
    FAIL() << "accepted";
  } catch (const CallError& e) {
    EXPECT_EQ(e.code(), remesh::v1::Error::CODE_DATA_LOSS);
    EXPECT_EQ(e.reason(), remesh::v1::Error::MESH_DAMAGED) << e.what();
  }
}

TEST(MeshAssembler, RefusesADeltaAgainstAMeshThatIsNotHere) {
  const auto base = base_mesh();
  const Messages messages = mesh_messages(edited(*base), {.base = base.get()});
  expect_damage([&] { assemble(messages); });
  Mesh other = *base;
  other.revision = "other";
  expect_damage([&] { assemble(messages, {}, std::make_shared<const Mesh>(other)); });
}

TEST(MeshAssembler, TakesNoMeshWithoutARevisionForTheBaseThatIsNotNamed) {
  const auto base = std::make_shared<const Mesh>(sample_mesh(2));
  const Messages messages = mesh_messages(edited(*base), {.base = base.get()});
  expect_damage([&] { assemble(messages, {}, base); });
}

TEST(MeshAssembler, SeesThatTheBaseIsNotWhatTheDaemonTookItFor) {
  const auto base = base_mesh();
  const Messages messages = mesh_messages(edited(*base), {.base = base.get()});
  Mesh other = *base;
  other.nodes[5][1] += 1;
  expect_damage([&] { assemble(messages, {}, std::make_shared<const Mesh>(other)); });
}

TEST(MeshAssembler, MissesAnArrayThatWasAskedFor) {
  const Messages messages =
      mesh_messages(sample_mesh(1), {.arrays = {remesh::v1::MESH_ARRAY_NODES}});
  expect_damage([&] { assemble(messages); });
}

struct Damage {
  const char* name;
  std::function<void(Messages&)> apply;
};

class DamagedTransfer : public testing::TestWithParam<Damage> {};

TEST_P(DamagedTransfer, IsDataLoss) {
  Messages messages = mesh_messages(sample_mesh(2), {.part_size = 500});
  GetParam().apply(messages);
  expect_damage([&] { assemble(messages); });
}

void flip(std::string& bytes, std::size_t at) { bytes[at] = static_cast<char>(bytes[at] ^ 1); }

MeshHeader::Array& entry(Messages& messages, MeshArray array) {
  for (auto& entry : *messages[0].mutable_header()->mutable_arrays())
    if (entry.array() == array) return entry;
  throw std::logic_error("no such array");
}

/// Replaces an array by one of the same length, with all checksums right.
void forge(Messages& messages, MeshArray array, const std::function<void(std::string&)>& change) {
  std::string bytes;
  for (const auto& message : messages)
    if (message.part().array() == array) bytes += message.part().data();
  change(bytes);
  entry(messages, array).set_digest(digest_of(bytes));
  for (auto& message : messages) {
    if (message.part().array() != array) continue;
    auto& part = *message.mutable_part();
    part.set_data(bytes.substr(part.offset(), part.data().size()));
    part.set_crc32c(crc32c(part.data()));
  }
}

/// The first number of an array of I32 becomes 2,130,706,432 and more.
Damage far_index(const char* name, MeshArray array) {
  return {name, [array](Messages& m) { forge(m, array, [](auto& bytes) { bytes[3] = 0x7F; }); }};
}

INSTANTIATE_TEST_SUITE_P(
    Parts, DamagedTransfer,
    testing::Values(
        Damage{"OneBitOfData", [](Messages& m) { flip(*m[3].mutable_part()->mutable_data(), 17); }},
        Damage{"OneBitOfDataUnderARightCrc",
               [](Messages& m) {
                 auto& part = *m[1].mutable_part();  // of NODES: any bits are a number
                 flip(*part.mutable_data(), 17);
                 part.set_crc32c(crc32c(part.data()));
               }},
        Damage{"PartLeftOut", [](Messages& m) { m.erase(m.begin() + 2); }},
        Damage{"LastPartLeftOut", [](Messages& m) { m.erase(m.end() - 2); }},
        Damage{"PartTwice", [](Messages& m) { m.insert(m.begin() + 2, m[2]); }},
        Damage{"PartsExchanged", [](Messages& m) { std::swap(m[2], m[3]); }},
        Damage{"NoHeader", [](Messages& m) { m.erase(m.begin()); }},
        Damage{"TwoHeaders", [](Messages& m) { m.insert(m.begin(), m[0]); }},
        Damage{"NoEnd", [](Messages& m) { m.pop_back(); }},
        Damage{"SomethingBehindTheEnd", [](Messages& m) { m.push_back(m[2]); }},
        Damage{"AnotherOffset", [](Messages& m) { m[2].mutable_part()->set_offset(3); }},
        Damage{"EmptyMessage", [](Messages& m) { m[2].Clear(); }},
        Damage{"PartsMiscounted", [](Messages& m) { m.back().mutable_end()->set_parts(1); }},
        Damage{"BytesMiscounted", [](Messages& m) { m.back().mutable_end()->set_bytes(1); }}),
    [](const auto& damage) { return std::string(damage.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Header, DamagedTransfer,
    testing::Values(
        Damage{
            "OneBitOfADigest",
            [](Messages& m) { flip(*entry(m, remesh::v1::MESH_ARRAY_TETS).mutable_digest(), 63); }},
        Damage{"DigestLeftOut",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_CELL_OWNERS).clear_digest(); }},
        Damage{"ArrayTwice",
               [](Messages& m) {
                 *m[0].mutable_header()->add_arrays() = entry(m, remesh::v1::MESH_ARRAY_NODES);
               }},
        Damage{"AnotherType",
               [](Messages& m) {
                 entry(m, remesh::v1::MESH_ARRAY_NODE_IDS).set_type(remesh::v1::ARRAY_TYPE_F64);
               }},
        Damage{"OtherComponents",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_NODES).set_components(1); }},
        Damage{"WrongCountOfNodes", [](Messages& m) { m[0].mutable_header()->set_nodes(5); }},
        Damage{"WrongCountOfFacets", [](Messages& m) { m[0].mutable_header()->set_facets(5); }},
        Damage{"WrongCountOfARow",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_TRANSFORMS).set_count(5); }},
        Damage{"WrongCountOfLines",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_FACET_GROUPS).set_count(5); }},
        Damage{"WrongBytes",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_NODES).set_bytes(5); }},
        Damage{"WrongBytesAsSent",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_NODES).set_data_bytes(5); }},
        Damage{"NoEncoding",
               [](Messages& m) { entry(m, remesh::v1::MESH_ARRAY_NODES).clear_encoding(); }},
        Damage{"SameWithoutABase",
               [](Messages& m) {
                 entry(m, remesh::v1::MESH_ARRAY_NODES).set_encoding(MeshHeader::ENCODING_SAME);
                 entry(m, remesh::v1::MESH_ARRAY_NODES).set_data_bytes(0);
               }},
        Damage{
            "TextAsADelta",
            [](Messages& m) {
              entry(m, remesh::v1::MESH_ARRAY_CELL_OWNERS).set_encoding(MeshHeader::ENCODING_DELTA);
            }}),
    [](const auto& damage) { return std::string(damage.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Content, DamagedTransfer,
    testing::Values(far_index("NodeOfATet", remesh::v1::MESH_ARRAY_TETS),
                    far_index("NodeOfAFacet", remesh::v1::MESH_ARRAY_FACETS),
                    far_index("TetOfAFacet", remesh::v1::MESH_ARRAY_FACET_TETS),
                    far_index("GroupOfAFacet", remesh::v1::MESH_ARRAY_FACET_GROUP),
                    far_index("CellOfATet", remesh::v1::MESH_ARRAY_TET_CELLS),
                    far_index("TransformOfANode", remesh::v1::MESH_ARRAY_NODE_TRANSFORMS),
                    Damage{"OriginOfANode",
                           [](Messages& m) {
                             forge(m, remesh::v1::MESH_ARRAY_NODE_ORIGINS,
                                   [](std::string& bytes) { bytes[0] = 3; });
                           }},
                    Damage{"FacetOfAnotherTet",
                           [](Messages& m) {
                             forge(m, remesh::v1::MESH_ARRAY_FACET_TETS,
                                   [](std::string& bytes) { bytes[0] = 40; });
                           }},
                    Damage{"TextThatEndsWithinALine",
                           [](Messages& m) {
                             forge(m, remesh::v1::MESH_ARRAY_FACET_GROUPS,
                                   [](std::string& bytes) { bytes.back() = 'x'; });
                           }}),
    [](const auto& damage) { return std::string(damage.param.name); });

}  // namespace
}  // namespace remeshd::client
