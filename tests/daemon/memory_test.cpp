#include <atomic>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/daemon/process.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;  // AddressSanitizer keeps something about each allocation
#else
constexpr bool kSanitized = false;
#endif

/// The environment of a daemon whose memory is measured: AddressSanitizer would keep what was
/// freed.
std::vector<std::string> keeps_nothing_freed() {
  const char* const options = std::getenv("ASAN_OPTIONS");
  return {std::string("ASAN_OPTIONS=") + (options != nullptr ? options : "") +
          ":quarantine_size_mb=1:thread_local_quarantine_size_kb=64"};
}

/// What hostile clients may cost a daemon, which is a process of its own here.
class Memory : public testing::Test {
 protected:
  Memory() : process_({"--listen", "127.0.0.1:0"}, keeps_nothing_freed()) {
    grpc::ChannelArguments arguments;
    arguments.SetMaxSendMessageSize(-1);
    channel_ = grpc::CreateCustomChannel(process_.address(), grpc::InsecureChannelCredentials(),
                                         arguments);
    stub_ = v1::RemeshService::NewStub(channel_);
    EXPECT_TRUE(serves());
    before_ = process_.memory("VmRSS");
  }
  bool serves() {
    grpc::ClientContext context;
    v1::GetServerInfoResponse reply;
    return stub_->GetServerInfo(&context, {}, &reply).ok();
  }
  /// MiB that the daemon has had at most beyond those of an idle one.
  [[nodiscard]] std::size_t growth() const { return (process_.memory("VmHWM") - before_) >> 20U; }
  static v1::CreateRevisionRequest document(std::size_t bytes) {
    v1::CreateRevisionRequest request;
    *request.mutable_model() = plate();
    request.mutable_model()->set_name(std::string(bytes, 'a'));
    return request;
  }

  Process process_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::RemeshService::Stub> stub_;
  std::size_t before_ = 0;
};

TEST_F(Memory, IsNotForCompressedMessages) {
  const auto bomb = document(200 << 20);
  for (const auto algorithm : {GRPC_COMPRESS_GZIP, GRPC_COMPRESS_DEFLATE}) {
    grpc::ClientContext context;
    context.set_compression_algorithm(algorithm);
    v1::CreateRevisionResponse reply;
    EXPECT_EQ(stub_->CreateRevision(&context, bomb, &reply).error_code(),
              StatusCode::UNIMPLEMENTED);
  }
  {
    grpc::ClientContext context;
    context.set_compression_algorithm(GRPC_COMPRESS_GZIP);
    const auto stream = stub_->EditStream(&context);
    v1::EditStreamRequest request;
    *request.mutable_create() = bomb;
    stream->Write(request);
    stream->WritesDone();
    v1::EditStreamResponse reply;
    while (stream->Read(&reply)) EXPECT_TRUE(reply.has_error());
    EXPECT_FALSE(stream->Finish().ok());
  }
  EXPECT_LT(growth(), 64U);
  EXPECT_TRUE(serves());
}

TEST_F(Memory, OfMessagesThatAreTooLargeIsBoundedTogether) {
  const auto large = document(100 << 20);
  std::vector<std::thread> clients;
  for (int c = 0; c < 8; ++c)
    clients.emplace_back([&] {
      grpc::ClientContext context;
      v1::CreateRevisionResponse reply;
      EXPECT_EQ(stub_->CreateRevision(&context, large, &reply).error_code(),
                StatusCode::RESOURCE_EXHAUSTED);
    });
  for (auto& client : clients) client.join();
  // 256 MiB and what the allocator needs beside; all of them would be 800.
  EXPECT_LT(growth(), kSanitized ? 600U : 400U);
  EXPECT_TRUE(serves());
}

TEST_F(Memory, OfAStreamWhoseClientNeverReadsIsBounded) {
  constexpr int kRequests = 200'000;
  grpc::ClientContext context;
  const auto stream = stub_->EditStream(&context);
  std::atomic<int> written = 0;
  std::thread writer([&] {
    v1::EditStreamRequest bad;
    bad.mutable_edit()->set_base("no such revision");
    for (int i = 0; i < kRequests; ++i, ++written)
      if (!stream->Write(i % 2 == 0 ? bad : v1::EditStreamRequest())) return;
  });
  for (int before = -1; before != written;) {
    before = written;
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }
  EXPECT_LT(growth(), kSanitized ? 96U : 32U) << written << " requests were sent";
  context.TryCancel();
  writer.join();
  EXPECT_FALSE(stream->Finish().ok());
  EXPECT_TRUE(serves());
}

}  // namespace
}  // namespace remeshd::test
