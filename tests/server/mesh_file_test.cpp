#include <chrono>
#include <thread>

#include "proto/checksum.h"
#include "remeshd/client.h"
#include "remeshd/mesh_file.h"
#include "server/limits.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

class MeshFile : public DaemonTest {
 protected:
  struct Received {
    v1::MeshFileHeader header;
    std::string file;
    std::size_t largest_message = 0;
    grpc::Status status;
  };
  /// All of a transfer, its parts checked on the way.
  Received receive(const std::string& revision, const std::string& format) {
    Received received;
    grpc::ClientContext context;
    const auto reader = stub().GetMeshFile(&context, request(revision, format));
    for (v1::GetMeshFileResponse message; reader->Read(&message);) {
      received.largest_message = std::max(received.largest_message, message.ByteSizeLong());
      if (message.has_header()) received.header = message.header();
      if (!message.has_part()) continue;
      EXPECT_EQ(message.part().offset(), received.file.size());
      EXPECT_EQ(message.part().crc32c(), crc32c(message.part().data()));
      received.file += message.part().data();
    }
    received.status = reader->Finish();
    return received;
  }
  static v1::GetMeshFileRequest request(const std::string& revision, const std::string& format) {
    v1::GetMeshFileRequest request;
    request.set_revision(revision);
    request.set_format(format);
    return request;
  }
  std::uint64_t memory_at_rest() {
    std::uint64_t before = 0, now = info().load().memory_bytes();
    while (before != now) {  // work gives its share back a moment after the reply
      before = now;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      now = info().load().memory_bytes();
    }
    return now;
  }
};

TEST_F(MeshFile, IsWhatTheClientLibraryWritesOfTheSameMesh) {
  create(plate());
  const std::string id = edit("plate", set("at", 11)).revision().id();
  const client::Mesh mesh = client::Client(channel_).get_mesh(id);
  for (const auto& [format, expected] :
       {std::pair("vtu", client::to_vtu(mesh)), std::pair("msh", client::to_msh(mesh)),
        std::pair("inp", client::to_inp(mesh))}) {
    const Received received = receive("plate", format);
    ASSERT_TRUE(received.status.ok()) << received.status.error_message();
    EXPECT_EQ(received.header.revision(), id);
    EXPECT_EQ(received.header.format(), format);
    EXPECT_EQ(received.header.bytes(), received.file.size());
    EXPECT_EQ(received.header.digest(), sha256_hex(received.file));
    EXPECT_EQ(received.file, expected) << format;
  }
}

TEST_F(MeshFile, ComesThroughTheClientLibrary) {
  create(plate());
  stub();
  EXPECT_EQ(client::Client(channel_).get_mesh_file("plate", "inp"), receive("plate", "inp").file);
}

TEST_F(MeshFile, OfTheModelIsWhatTheEngineMakesOfTheRevision) {
  create(plate());
  const std::string id = edit("plate", set("at", 11)).revision().id();
  const Received received = receive("plate", "step");
  ASSERT_TRUE(received.status.ok()) << received.status.error_message();
  EXPECT_EQ(received.header.format(), "step");
  EXPECT_EQ(received.header.digest(), sha256_hex(received.file));
  EXPECT_EQ(received.file, "ISO-10303-21;plate;mm;" + id + ".step");
}

TEST_F(MeshFile, LargerThanAMessageComesInSeveralParts) {
  create(create_request(plate(), 50000));
  const Received received = receive("plate", "inp");
  EXPECT_GT(received.file.size(), std::size_t{3} << 20U);
  EXPECT_LE(received.largest_message, std::size_t{1} << 20U);
}

TEST_F(MeshFile, OfAnotherFormatIsRefusedAndThoseThatThereAreNamed) {
  create(plate());
  for (const char* format : {"", "stl", ".inp", "INP"}) {
    const grpc::Status status = receive("plate", format).status;
    EXPECT_EQ(detail(status).reason(), v1::Error::OPTIONS_INVALID) << format;
    EXPECT_EQ(detail(status).parameter(), "format");
    EXPECT_THAT(status.error_message(), testing::HasSubstr("vtu, msh, inp, step"));
  }
}

TEST_F(MeshFile, OfAnUnknownRevisionIsNotFound) {
  create(plate());
  EXPECT_EQ(detail(receive("plank", "inp").status).reason(), v1::Error::REVISION_NOT_FOUND);
  EXPECT_EQ(detail(receive("", "inp").status).reason(), v1::Error::REVISION_MISSING);
}

TEST_F(MeshFile, IsMadeOfAMeshThatIsInTheStoreAlone) {
  use_store();
  create(plate());
  const std::string before = receive("plate", "msh").file;
  start();
  EXPECT_EQ(receive("plate", "msh").file, before);
}

TEST_F(MeshFile, TakesMemoryUntilItsClientHasIt) {
  create(create_request(plate(), 200000));
  const std::uint64_t before = memory_at_rest();
  grpc::ClientContext context;
  const auto reader = stub().GetMeshFile(&context, request("plate", "inp"));
  v1::GetMeshFileResponse message;
  ASSERT_TRUE(reader->Read(&message));
  ASSERT_TRUE(message.has_header());
  EXPECT_GE(info().load().memory_bytes(), before + message.header().bytes());
  context.TryCancel();
  reader->Finish();
  EXPECT_EQ(memory_at_rest(), before);
}

TEST_F(MeshFile, IsRefusedWhereWorkersAndQueueAreFull) {
  options_.workers = 1;
  options_.queue = 1;
  create(plate());
  engine_.close_gate();
  const auto make = [this](double radius) {
    v1::RevisionResult reply;
    EXPECT_TRUE(try_create(create_request(plate(radius)), &reply).ok());
  };
  std::thread at_work(make, 6);
  EXPECT_TRUE(engine_.wait_at_gate(1));
  std::thread waiting(make, 7);
  while (info().load().queued() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(detail(receive("plate", "inp").status).reason(), v1::Error::BUSY);
  engine_.open_gate();
  at_work.join();
  waiting.join();
  EXPECT_TRUE(receive("plate", "inp").status.ok());
}

}  // namespace
}  // namespace remeshd::test
