#include "server/service/message_stream.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "remesh/v1/cache.pb.h"
#include "server/limits.h"
#include "server/session/session_error.h"

namespace remeshd::test {
namespace {

/// A stream of no server: what gRPC would tell it, the test tells it.
class MessageStreamTest : public testing::Test {
 protected:
  ~MessageStreamTest() override { stream_->OnDone(); }

  static remesh::v1::VerifyCacheResponse message(std::size_t bytes) {
    remesh::v1::VerifyCacheResponse out;
    out.mutable_finding()->set_what(std::string(bytes, 'x'));
    return out;
  }
  /// Sends messages until no more may wait; returns how many.
  int send_all_that_may_wait(std::size_t bytes) {
    int sent = 0;
    do {
      stream_->send(message(bytes));
      ++sent;
    } while (sent < 10000 && !stream_->wait_for_client([this] { ++told_; }));
    return sent;
  }

  grpc::CallbackServerContext context_;
  const std::shared_ptr<MessageStream> stream_ = MessageStream::start(
      &context_, std::make_shared<CallRecord>(std::make_shared<FrontDesk>(), "M", context_));
  int told_ = 0;
};

TEST_F(MessageStreamTest, WhatAClientDoesNotTakeIsBoundedByBytes) {
  constexpr std::size_t kBytes = 10'000;
  const int sent = send_all_that_may_wait(kBytes);
  EXPECT_GE(sent * (kBytes + 100), limits::kUntakenBytes);
  EXPECT_LE((sent - 1) * kBytes, limits::kUntakenBytes);
}

TEST_F(MessageStreamTest, ALargeMessageIsTakenBeforeTheNextIsMade) {
  EXPECT_EQ(send_all_that_may_wait(limits::kMeshPartBytes), 1);
}

TEST_F(MessageStreamTest, WhoMadeTheMessagesGoesOnWhileTheLastOnesAreWritten) {
  const int sent = send_all_that_may_wait(limits::kUntakenBytes / 4);
  EXPECT_EQ(told_, 0);
  for (int k = 0; k < sent; ++k) {
    EXPECT_FALSE(stream_->all_taken());
    stream_->OnWriteDone(true);
    EXPECT_EQ(told_, 1) << "once, as soon as less waits than may";
  }
  EXPECT_TRUE(stream_->all_taken());
  stream_->send(message(1));
  stream_->OnWriteDone(true);
  EXPECT_EQ(told_, 1);
}

TEST_F(MessageStreamTest, AfterTheEndNothingIsSentAndNobodyGoesOn) {
  send_all_that_may_wait(limits::kUntakenBytes);
  stream_->fail(error::cancelled());
  stream_->send(message(1));
  stream_->OnWriteDone(true);
  EXPECT_TRUE(stream_->all_taken());
  EXPECT_TRUE(stream_->wait_for_client([this] { ++told_; })) << "who makes messages stops";
  EXPECT_EQ(told_, 0);
}

TEST_F(MessageStreamTest, AClientThatIsGoneIsSentNothingMore) {
  stream_->send(message(1));
  stream_->send(message(1));
  stream_->OnWriteDone(false);
  stream_->send(message(1));
  EXPECT_TRUE(stream_->all_taken());
}

TEST_F(MessageStreamTest, ItsShareOfTheMemoryIsGivenBackAtItsEnd) {
  MemoryBudget memory(1000);
  const auto stream = MessageStream::start(
      &context_, std::make_shared<CallRecord>(std::make_shared<FrontDesk>(), "M", context_));
  stream->keep(memory.take(600, {}, 1));
  EXPECT_EQ(memory.leased(), 600U);
  stream->end();
  stream->OnDone();
  EXPECT_EQ(memory.leased(), 0U);
}

}  // namespace
}  // namespace remeshd::test
