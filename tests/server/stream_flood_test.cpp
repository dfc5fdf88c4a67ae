#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

#include "engine/base/random.h"
#include "server/limits.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

/// An EditStream of which requests are sent on a thread of their own.
class StreamFloods : public DaemonTest {
 protected:
  using Stream = grpc::ClientReaderWriter<v1::EditStreamRequest, v1::EditStreamResponse>;

  void open() {
    context_ = std::make_unique<grpc::ClientContext>();
    stream_ = stub().EditStream(context_.get());
  }
  /// Sends `count` requests, as fast as the daemon takes them.
  template <typename Make>
  void flood(int count, Make make) {
    writer_ = std::thread([this, count, make] {
      for (int i = 0; i < count; ++i) {
        if (!stream_->Write(make(i))) return;
        ++written_;
      }
    });
  }
  /// Waits until no request has been taken for half a second.
  void wait_until_writing_rests() const {
    for (int before = -1; before != written_;) {
      before = written_;
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
  }
  v1::EditStreamResponse answer() {
    v1::EditStreamResponse reply;
    while (stream_->Read(&reply))
      if (!reply.has_progress()) return reply;
    ADD_FAILURE() << "the stream ended";
    return reply;
  }
  ~StreamFloods() override {
    engine_.open_gate();
    if (context_) context_->TryCancel();
    if (writer_.joinable()) writer_.join();
  }

  std::unique_ptr<grpc::ClientContext> context_;
  std::unique_ptr<Stream> stream_;
  std::thread writer_;
  std::atomic<int> written_ = 0;
};

v1::EditStreamRequest large(int number, std::size_t bytes) {
  v1::EditStreamRequest request;
  request.mutable_edit()->set_request_id(std::to_string(number));
  request.mutable_edit()->set_base("no such revision");
  auto& feature = *request.mutable_edit()->mutable_edit()->add_edits()->mutable_remove_feature();
  feature.set_feature(std::string(bytes, 'x'));
  return request;
}

TEST_F(StreamFloods, OfEmptyRequestsAreAnsweredInFullOnceTheClientReads) {
  constexpr int kRequests = 30000;
  open();
  flood(kRequests, [](int) { return v1::EditStreamRequest(); });
  for (int i = 0; i < kRequests; ++i)
    ASSERT_EQ(answer().error().reason(), v1::Error::SIDE_INVALID) << i;
  writer_.join();
  stream_->WritesDone();
  v1::EditStreamResponse reply;
  EXPECT_FALSE(stream_->Read(&reply));
  EXPECT_TRUE(stream_->Finish().ok());
}

TEST_F(StreamFloods, OfLargeRequestsStopAtTheBoundAndGoOnInOrder) {
  constexpr int kRequests = 40;
  start();
  create(plate());
  engine_.close_gate();
  open();
  v1::EditStreamRequest first;
  *first.mutable_edit() = edit_request("plate", set("at", 11));
  first.mutable_edit()->set_request_id("first");
  ASSERT_TRUE(stream_->Write(first));
  ASSERT_TRUE(engine_.wait_at_gate(1));
  flood(kRequests, [](int i) { return large(i, std::size_t{2} << 20); });
  wait_until_writing_rests();
  // 8 MiB wait as requests; some more are on the way, in the connection's windows.
  EXPECT_LT(written_, 12);
  engine_.open_gate();
  EXPECT_EQ(answer().request_id(), "first");
  for (int i = 0; i < kRequests; ++i) {
    const auto reply = answer();
    EXPECT_EQ(reply.request_id(), std::to_string(i));
    EXPECT_EQ(reply.error().code(), v1::Error::CODE_NOT_FOUND);
  }
}

TEST_F(StreamFloods, OfLargeRequestsAreRefusedOnceTheyHaveFilledTheMemory) {
  constexpr int kRequests = 3;
  options_.memory = 6U << 20U;
  start();
  create(plate());
  engine_.close_gate();
  open();
  v1::EditStreamRequest first;
  *first.mutable_edit() = edit_request("plate", set("at", 11));
  ASSERT_TRUE(stream_->Write(first));
  ASSERT_TRUE(engine_.wait_at_gate(1));
  flood(kRequests, [](int i) { return large(i, std::size_t{2} << 20); });
  wait_until_writing_rests();
  engine_.open_gate();
  EXPECT_TRUE(answer().has_result());
  EXPECT_EQ(answer().error().code(), v1::Error::CODE_NOT_FOUND) << "it had room to wait";
  answer();
  const v1::Error refused = answer().error();
  EXPECT_EQ(refused.reason(), v1::Error::MEMORY_FULL);
  EXPECT_GT(refused.retry_after(), 0);
}

TEST_F(StreamFloods, AreRefusedOnceStreamsHaveTakenTheMemory) {
  options_.memory = limits::kStreamMemory;
  const auto refused = [this] {
    grpc::ClientContext context;
    const auto stream = stub().EditStream(&context);
    stream->WritesDone();
    v1::EditStreamResponse reply;
    while (stream->Read(&reply)) {
    }
    const grpc::Status status = stream->Finish();
    return !status.ok() && detail(status).reason() == v1::Error::MEMORY_FULL;
  };
  EXPECT_FALSE(refused());
  v1::EditStreamResponse reply;
  do {  // its memory comes back a moment after its end
    open();
    stream_->Write({});
  } while (!stream_->Read(&reply));
  EXPECT_TRUE(refused());
  stream_->WritesDone();
  EXPECT_TRUE(stream_->Finish().ok());
  while (refused()) std::this_thread::yield();
}

TEST_F(StreamFloods, AreCancelledById) {
  start();
  create(plate());
  engine_.close_gate();
  open();
  for (int i = 0; i < 3; ++i) {
    v1::EditStreamRequest request;
    *request.mutable_edit() = edit_request("plate", set("at", 11 + i));
    request.mutable_edit()->set_request_id("edit" + std::to_string(i));
    ASSERT_TRUE(stream_->Write(request));
  }
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(stream_->Write(large(i, 10)));
  ASSERT_TRUE(engine_.wait_at_gate(1));
  for (const char* id : {"edit2", "999", "edit0"}) {
    v1::EditStreamRequest request;
    request.mutable_cancel()->set_request_id(id);
    ASSERT_TRUE(stream_->Write(request));
  }
  ASSERT_TRUE(engine_.wait_stopped(1));
  engine_.open_gate();
  EXPECT_EQ(answer().error().code(), v1::Error::CODE_CANCELLED);
  EXPECT_TRUE(answer().has_result());
  EXPECT_EQ(answer().error().code(), v1::Error::CODE_CANCELLED);
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(answer().error().code(),
              i == 999 ? v1::Error::CODE_CANCELLED : v1::Error::CODE_NOT_FOUND);
}

TEST_F(StreamFloods, WithoutAReaderEndWithTheDaemon) {
  open();
  flood(1'000'000, [](int) { return v1::EditStreamRequest(); });
  while (written_ < 1000) std::this_thread::yield();
  daemon_->shutdown();
  writer_.join();
  v1::EditStreamResponse reply;  // what has reached the client already
  while (stream_->Read(&reply)) {
  }
  EXPECT_FALSE(stream_->Finish().ok());
}

/// Streams that end at a random moment in what they are doing. REMESHD_RANDOM_CANCELS gives their
/// number: 100,000 under AddressSanitizer are the full count.
TEST_F(StreamFloods, CancelledAtRandomMomentsLeaveADaemonThatServes) {
  const char* wanted = std::getenv("REMESHD_RANDOM_CANCELS");
  const int streams = wanted != nullptr ? std::atoi(wanted) : 400;
  constexpr int kClients = 4;
  start();
  create(plate());
  std::vector<std::thread> clients;
  for (int c = 0; c < kClients; ++c)
    clients.emplace_back([&, c] {
      Random random(static_cast<std::uint64_t>(c) + 1);
      for (int i = c; i < streams; i += kClients) {
        grpc::ClientContext context;
        const auto stream = stub_->EditStream(&context);
        // Of each kind some: refused at once, made anew, from the cache, mesh to be read.
        std::uint64_t replies = 0;  // at least; there is progress too
        for (std::uint64_t n = random.below(8); n > 0; --n) {
          v1::EditStreamRequest request;
          const std::uint64_t kind = random.below(4);
          if (kind == 1)
            *request.mutable_edit() =
                edit_request("plate@1", set("at", 11 + static_cast<double>(random.below(50))));
          if (kind == 2) *request.mutable_create() = create_request(plate());
          if (kind == 3) request.mutable_cancel()->set_request_id("");
          if (!stream->Write(request)) break;
          if (kind != 3) ++replies;
        }
        // Some send more than may wait: then workers are the ones that read on.
        for (int n = random.below(32) == 0 ? 4500 : 0; n > 0; --n)
          if (!stream->Write({})) break;
        v1::EditStreamResponse reply;
        for (std::uint64_t n = std::min(random.below(4), replies); n > 0; --n)
          if (!stream->Read(&reply)) break;
        for (std::uint64_t n = random.below(8); n > 0; --n) std::this_thread::yield();
        if (random.below(4) == 0) stream->WritesDone();
        context.TryCancel();
        while (stream->Read(&reply)) {
        }
        stream->Finish();

        grpc::ClientContext mesh_context;
        v1::GetMeshRequest request;
        request.set_revision("plate");
        const auto reader = stub_->GetMesh(&mesh_context, request);
        v1::GetMeshResponse message;
        if (random.below(2) == 0) reader->Read(&message);
        mesh_context.TryCancel();
        while (reader->Read(&message)) {
        }
        reader->Finish();
      }
    });
  for (auto& client : clients) client.join();
  EXPECT_TRUE(serves());
}

}  // namespace
}  // namespace remeshd::test
