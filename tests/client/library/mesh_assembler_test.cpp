#include "client/library/mesh_assembler.h"

#include <gtest/gtest.h>

#include <functional>

#include "remeshd/error.h"
#include "tests/client/mesh_messages.h"
#include "tests/client/sample_mesh.h"

namespace remeshd::client {
namespace {

using Messages = std::vector<remesh::v1::MeshMessage>;

Mesh assemble(const Messages& messages) {
  MeshAssembler assembler;
  for (const auto& message : messages) assembler.add(message);
  return assembler.finish();
}

TEST(MeshAssembler, PutsTheMeshTogetherWhateverTheSizeOfTheParts) {
  const Mesh mesh = sample_mesh(2);
  for (const std::size_t size : {std::size_t{1000}, std::size_t{13}, std::size_t{1} << 20})
    EXPECT_EQ(assemble(mesh_messages(mesh, size)), mesh) << size;
}

struct Damage {
  const char* name;
  std::function<void(Messages&)> apply;
};

class DamagedTransfer : public testing::TestWithParam<Damage> {};

TEST_P(DamagedTransfer, IsDataLoss) {
  Messages messages = mesh_messages(sample_mesh(2), 500);
  GetParam().apply(messages);
  try {
    assemble(messages);
    FAIL() << "accepted";
  } catch (const CallError& e) {
    EXPECT_EQ(e.code(), remesh::v1::Error::DATA_LOSS);
    EXPECT_EQ(e.detail().reason(), "MeshDamaged");
  }
}

void flip(std::string& bytes, std::size_t at) { bytes[at] = static_cast<char>(bytes[at] ^ 1); }

/// Replaces the data of a part and makes its own checksum right again.
void forge(remesh::v1::MeshPart& part, const std::string& data) {
  part.set_data(data);
  part.set_crc32c(crc32c(data));
}

/// Makes the checksum over everything right again.
void sign(Messages& messages) {
  std::string all;
  for (const auto& message : messages) all += message.part().data();
  Sha256 digest;
  digest.update(all);
  messages.back().mutable_end()->set_sha256(digest.finish());
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedTransfer,
    testing::Values(
        Damage{"OneBitOfData", [](Messages& m) { flip(*m[3].mutable_part()->mutable_data(), 17); }},
        Damage{"OneBitOfDataUnderARightCrc",
               [](Messages& m) {
                 std::string data = m[3].part().data();
                 flip(data, 17);
                 forge(*m[3].mutable_part(), data);
               }},
        Damage{"OneBitOfTheChecksum",
               [](Messages& m) { flip(*m.back().mutable_end()->mutable_sha256(), 31); }},
        Damage{"PartLeftOut", [](Messages& m) { m.erase(m.begin() + 2); }},
        Damage{"LastPartLeftOut", [](Messages& m) { m.erase(m.end() - 2); }},
        Damage{"PartTwice", [](Messages& m) { m.insert(m.begin() + 2, m[2]); }},
        Damage{"PartsExchanged", [](Messages& m) { std::swap(m[2], m[3]); }},
        Damage{"NoHeader", [](Messages& m) { m.erase(m.begin()); }},
        Damage{"TwoHeaders", [](Messages& m) { m.insert(m.begin(), m[0]); }},
        Damage{"NoEnd", [](Messages& m) { m.pop_back(); }},
        Damage{"SomethingBehindTheEnd", [](Messages& m) { m.push_back(m[2]); }},
        Damage{"EmptyMessage", [](Messages& m) { m[2].Clear(); }},
        Damage{"WrongCount", [](Messages& m) { m[0].mutable_header()->set_nodes(5); }},
        Damage{"IndexOutOfRange",
               [](Messages& m) {
                 for (auto& message : m) {
                   if (message.part().array() != remesh::v1::TETS) continue;
                   std::string data = message.part().data();
                   data[3] = 0x7F;  // the first corner is node 2,130,706,432 and more
                   forge(*message.mutable_part(), data);
                   break;
                 }
                 sign(m);
               }}),
    [](const auto& damage) { return std::string(damage.param.name); });

}  // namespace
}  // namespace remeshd::client
