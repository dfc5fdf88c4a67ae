#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "server/guard/doorman.h"
#include "tests/server/daemon_fixture.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

const std::string kAnna = "anna-s-secret-token", kOther = "another-secret-token";

/// Streams of the tenant `anna` while the file of tokens changes.
class RevokedStreams : public DaemonTest {
 protected:
  using Stream = grpc::ClientReaderWriter<v1::EditStreamRequest, v1::EditStreamResponse>;

  RevokedStreams() {
    write("anna " + kAnna + "\n");
    options_.doorman = std::make_shared<Doorman>(file());
    context_.AddMetadata("authorization", "Bearer " + kAnna);
    context_.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(10));
  }
  ~RevokedStreams() override { engine_.open_gate(); }

  [[nodiscard]] std::string file() const { return folder_of_file_.file("tokens"); }
  void write(const std::string& text) const {
    std::ofstream(file()) << text;
    std::filesystem::permissions(file(), std::filesystem::perms(0600));
  }
  void change_tokens(const std::string& text) {
    write(text);
    options_.doorman->reload();
  }

  std::unique_ptr<Stream> open_stream() { return stub().EditStream(&context_); }
  static void send(Stream& stream, const v1::CreateRevisionRequest& create) {
    v1::EditStreamRequest request;
    *request.mutable_create() = create;
    stream.Write(request);
  }
  static bool read_result(Stream& stream) {
    v1::EditStreamResponse reply;
    while (stream.Read(&reply))
      if (reply.has_result()) return true;
    return false;
  }
  static void expect_revoked(const grpc::Status& status) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
    EXPECT_EQ(detail(status).reason(), v1::Error::CREDENTIALS_INVALID);
  }

  Folder folder_of_file_;
  grpc::ClientContext context_;
};

TEST_F(RevokedStreams, OfEditsEndInPlaceOfTheirNextRequest) {
  const auto stream = open_stream();
  send(*stream, create_request(plate()));
  ASSERT_TRUE(read_result(*stream));
  change_tokens("anna " + kOther + "\n");
  send(*stream, create_request(plate(6)));
  EXPECT_FALSE(read_result(*stream));
  expect_revoked(stream->Finish());
  EXPECT_EQ(engine_.started(), 1);
}

TEST_F(RevokedStreams, DoNotCarryOutWhatWasSentAhead) {
  const auto stream = open_stream();
  stub();
  engine_.close_gate();
  for (int r = 3; r < 6; ++r) send(*stream, create_request(plate(r)));
  ASSERT_TRUE(engine_.wait_at_gate(1));
  change_tokens("anna " + kOther + "\n");
  engine_.open_gate();
  while (read_result(*stream)) {
  }
  expect_revoked(stream->Finish());
  EXPECT_EQ(engine_.started(), 1);
}

TEST_F(RevokedStreams, EndWhereTheTokenIsAnotherTenantsNow) {
  const auto stream = open_stream();
  send(*stream, create_request(plate()));
  ASSERT_TRUE(read_result(*stream));
  change_tokens("ben " + kAnna + "\nanna " + kOther + "\n");
  send(*stream, create_request(plate(6)));
  EXPECT_FALSE(read_result(*stream));
  expect_revoked(stream->Finish());
}

TEST_F(RevokedStreams, AreThoseOfTheTokensThatWentAlone) {
  const auto stream = open_stream();
  change_tokens("ben " + kOther + "\nanna " + kAnna + "\n");
  send(*stream, create_request(plate()));
  EXPECT_TRUE(read_result(*stream));
  stream->WritesDone();
  EXPECT_FALSE(read_result(*stream));
  EXPECT_TRUE(stream->Finish().ok());
}

TEST_F(RevokedStreams, OfAMeshEndWithTheNextMessage) {
  const auto stream = open_stream();
  send(*stream, create_request(plate(), 400'000));
  ASSERT_TRUE(read_result(*stream));
  grpc::ClientContext context;
  context.AddMetadata("authorization", "Bearer " + kAnna);
  v1::GetMeshRequest request;
  request.set_revision("plate");
  const auto reader = stub().GetMesh(&context, request);
  v1::GetMeshResponse message;
  ASSERT_TRUE(reader->Read(&message));
  change_tokens("anna " + kOther + "\n");
  bool ended = false;
  while (reader->Read(&message)) ended |= message.mesh().has_end();
  EXPECT_FALSE(ended);
  expect_revoked(reader->Finish());
}

}  // namespace
}  // namespace remeshd::test
