#include "server/service/stream_queue.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

constexpr StreamQueue::Limits kLimits{
    .requests = 3, .request_bytes = 100, .replies = 2, .reply_bytes = 50};

StreamQueue::Request request(const std::string& id, std::size_t bytes = 1) {
  return {.id = id, .bytes = std::string(bytes, 'x')};
}

grpc::ByteBuffer reply(const std::string& text) {
  const grpc::Slice slice(text);
  return {&slice, 1};
}

std::string text_of(const grpc::ByteBuffer& bytes) {
  grpc::Slice slice;
  EXPECT_TRUE(bytes.DumpToSingleSlice(&slice).ok());
  return {reinterpret_cast<const char*>(slice.begin()), slice.size()};
}

TEST(StreamQueue, ReadsUntilAsManyRequestsWaitAsMay) {
  StreamQueue queue(kLimits);
  for (const char* id : {"a", "b", "c"}) {
    EXPECT_TRUE(queue.may_read());
    queue.add(request(id));
  }
  EXPECT_FALSE(queue.may_read());
  EXPECT_EQ(queue.begin().id, "a");
  EXPECT_TRUE(queue.may_read());
}

TEST(StreamQueue, ReadsUntilTheWaitingBytesAreAsManyAsMayBe) {
  StreamQueue queue(kLimits);
  queue.add(request("small", 99));
  EXPECT_TRUE(queue.may_read());
  queue.add(request("any size", 1000));
  EXPECT_FALSE(queue.may_read());
  queue.begin();
  EXPECT_FALSE(queue.may_read());
  queue.answer(1, reply("done"));
  queue.begin();
  EXPECT_TRUE(queue.may_read());
}

TEST(StreamQueue, NeitherReadsNorBeginsWhileRepliesAreAtTheirNumber) {
  StreamQueue queue(kLimits);
  for (const char* id : {"a", "b", "c"}) queue.add(request(id));
  for (std::uint64_t turn : {1, 2}) {
    EXPECT_TRUE(queue.may_begin());
    EXPECT_EQ(queue.begin().turn, turn);
    EXPECT_TRUE(queue.answer(turn, reply("done")));
  }
  EXPECT_FALSE(queue.may_begin());
  EXPECT_FALSE(queue.may_read());
  queue.next_reply();
  EXPECT_TRUE(queue.may_begin());
  EXPECT_TRUE(queue.may_read());
}

TEST(StreamQueue, NeitherReadsNorBeginsWhileRepliesAreAtTheirBytes) {
  StreamQueue queue(kLimits);
  queue.add(request("a"));
  queue.add(request("b"));
  queue.begin();
  queue.answer(1, reply(std::string(50, 'x')));
  EXPECT_FALSE(queue.may_begin());
  EXPECT_FALSE(queue.may_read());
  queue.next_reply();
  EXPECT_TRUE(queue.may_begin());
  EXPECT_TRUE(queue.may_read());
}

TEST(StreamQueue, HasOneRequestAtWorkAtATime) {
  StreamQueue queue(kLimits);
  queue.add(request("a"));
  queue.add(request("b"));
  EXPECT_EQ(queue.begin().id, "a");
  EXPECT_FALSE(queue.may_begin());
  queue.answer(1, reply("done"));
  EXPECT_EQ(queue.begin().id, "b");
}

TEST(StreamQueue, KeepsTheLatestProgressOnly) {
  StreamQueue queue(kLimits);
  queue.add(request("a"));
  queue.begin();
  for (const char* event : {"one", "two", "three"}) queue.progress(1, reply(event));
  EXPECT_EQ(text_of(queue.next_reply()), "three");
  EXPECT_FALSE(queue.has_reply());
}

TEST(StreamQueue, SendsNoProgressOfARequestThatHasEnded) {
  StreamQueue queue(kLimits);
  queue.add(request("a"));
  queue.add(request("b"));
  queue.begin();
  queue.progress(1, reply("still waiting to be sent"));
  queue.answer(1, reply("done"));
  queue.progress(1, reply("too late"));
  EXPECT_EQ(text_of(queue.next_reply()), "done");
  EXPECT_FALSE(queue.has_reply());
  queue.begin();
  queue.progress(1, reply("much too late"));
  EXPECT_FALSE(queue.has_reply());
}

TEST(StreamQueue, TakesOneAnswerForARequest) {
  StreamQueue queue(kLimits);
  queue.add(request("a"));
  queue.add(request("b"));
  queue.begin();
  EXPECT_TRUE(queue.answer(1, reply("done")));
  EXPECT_FALSE(queue.answer(1, reply("again")));
  queue.begin();
  EXPECT_FALSE(queue.answer(1, reply("again")));
  EXPECT_TRUE(queue.at_work(2));
}

TEST(StreamQueue, CancelsWhatWaitsAndTellsOfWhatIsAtWork) {
  StreamQueue queue(kLimits);
  for (const char* id : {"a", "b", "b"}) queue.add(request(id));
  queue.begin();
  EXPECT_TRUE(queue.cancel("a"));
  EXPECT_FALSE(queue.cancel("b"));
  EXPECT_FALSE(queue.cancel("nobody"));
  for (std::uint64_t turn : {1, 2}) {
    queue.answer(turn, reply("done"));
    queue.next_reply();
    EXPECT_TRUE(queue.begin().cancelled);
  }
}

TEST(StreamQueue, ClosedKeepsNothingButWhatIsAtWork) {
  StreamQueue queue(kLimits);
  for (const char* id : {"a", "b", "c"}) queue.add(request(id));
  queue.begin();
  queue.progress(1, reply("event"));
  queue.close();
  EXPECT_FALSE(queue.has_reply());
  queue.add(request("d"));
  queue.progress(1, reply("event"));
  EXPECT_FALSE(queue.idle());
  EXPECT_TRUE(queue.answer(1, reply("done")));
  EXPECT_TRUE(queue.idle());
}

}  // namespace
}  // namespace remeshd
