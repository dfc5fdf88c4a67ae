#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "proto/checksum.h"
#include "remeshd/client.h"
#include "remeshd/error.h"
#include "tests/client/fake_daemon.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using remesh::v1::GetMeshFileResponse;

/// A file of these parts, as a daemon sends it.
std::vector<GetMeshFileResponse> file_of(const std::vector<std::string>& parts) {
  std::vector<GetMeshFileResponse> messages(1);
  std::string file;
  for (const std::string& data : parts) {
    auto& part = *messages.emplace_back().mutable_part();
    part.set_offset(file.size());
    part.set_data(data);
    part.set_crc32c(crc32c(data));
    file += data;
  }
  auto& header = *messages.front().mutable_header();
  header.set_revision("rev-1");
  header.set_bytes(file.size());
  header.set_digest(sha256_hex(file));
  return messages;
}

TEST(MeshFileTransfer, GivesTheFileAndTellsHowFarItIs) {
  FakeDaemon daemon;
  daemon.service.file_messages = file_of({"*NODE\n", "1, 0\n"});
  std::vector<std::uint64_t> done;
  const auto file = Client::connect(daemon.address)
                        .get_mesh_file("rev-1", "inp", {}, [&](std::uint64_t have, std::uint64_t) {
                          done.push_back(have);
                        });
  EXPECT_EQ(file, "*NODE\n1, 0\n");
  EXPECT_THAT(done, testing::ElementsAre(0, 6, 11));
  ASSERT_EQ(daemon.service.file_requests.size(), 1U);
  EXPECT_EQ(daemon.service.file_requests[0].revision(), "rev-1");
  EXPECT_EQ(daemon.service.file_requests[0].format(), "inp");
}

TEST(MeshFileTransfer, BeginsAgainWhereTheConnectionBreaks) {
  FakeDaemon daemon;
  daemon.service.file_messages = file_of({"*NODE\n", "1, 0\n"});
  daemon.service.mesh_break = 2;
  EXPECT_EQ(Client::connect(daemon.address).get_mesh_file("rev-1", "inp"), "*NODE\n1, 0\n");
  EXPECT_EQ(daemon.service.file_requests.size(), 2U);
}

TEST(MeshFileTransfer, ThatIsCutAtTheSamePlaceEachTimeIsGivenUp) {
  FakeDaemon daemon;
  daemon.service.file_messages = file_of({"*NODE\n", "1, 0\n"});
  daemon.service.file_break = 2;
  CallOptions briefly;
  briefly.timeout = 5;  // else it might be tried for ever
  briefly.reconnect = 0.5;
  EXPECT_THROW(
      static_cast<void>(Client::connect(daemon.address).get_mesh_file("rev-1", "inp", briefly)),
      CallError);
  EXPECT_GT(daemon.service.file_requests.size(), 1U);
  EXPECT_LT(daemon.service.file_requests.size(), 7U);
}

TEST(MeshFileTransfer, WithAnyFaultIsDataLoss) {
  const auto good = file_of({"*NODE\n", "1, 0\n"});
  auto no_header = good, gap = good, crc = good, digest = good, cut = good, longer = good;
  no_header.erase(no_header.begin());
  gap.erase(gap.begin() + 1);
  crc[2].mutable_part()->set_crc32c(7);
  digest[0].mutable_header()->set_digest(sha256_hex("another"));
  cut.pop_back();
  longer[0].mutable_header()->set_bytes(8);
  for (const auto& messages : {no_header, gap, crc, digest, cut, longer, {}}) {
    FakeDaemon daemon;
    daemon.service.file_messages = messages;
    try {
      static_cast<void>(Client::connect(daemon.address).get_mesh_file("rev-1", "inp"));
      ADD_FAILURE() << "a file that is not whole is taken";
    } catch (const CallError& error) {
      EXPECT_EQ(error.detail().reason(), Error::MESH_DAMAGED) << error.what();
    }
  }
}

TEST(MeshFileTransfer, TellsTheDaemonsError) {
  FakeDaemon daemon;
  daemon.service.failure = make_error(Error::CODE_INVALID_ARGUMENT, Error::OPTIONS_INVALID);
  EXPECT_THROW(static_cast<void>(Client::connect(daemon.address).get_mesh_file("rev-1", "stl")),
               CallError);
}

}  // namespace
}  // namespace remeshd::client
