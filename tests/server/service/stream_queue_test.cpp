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

/// As much as is asked for.
MemoryBudget::Lease memory() {
  static MemoryBudget budget(1ULL << 40U);
  return budget.try_take(0);
}

/// Replies `mesh 0`, `mesh 1`, ...
class Meshes final : public ReplySource {
 public:
  explicit Meshes(int count, std::uint64_t own_bytes = 0) : count_(count), bytes_(own_bytes) {}
  grpc::ByteBuffer next() override { return reply("mesh " + std::to_string(next_++)); }
  [[nodiscard]] bool ended() const override { return next_ == count_; }
  [[nodiscard]] std::uint64_t own_bytes() const override { return bytes_; }

 private:
  const int count_;
  const std::uint64_t bytes_;
  int next_ = 0;
};

std::string text_of(const grpc::ByteBuffer& bytes) {
  grpc::Slice slice;
  EXPECT_TRUE(bytes.DumpToSingleSlice(&slice).ok());
  return {reinterpret_cast<const char*>(slice.begin()), slice.size()};
}

TEST(StreamQueue, ReadsUntilAsManyRequestsWaitAsMay) {
  StreamQueue queue(memory(), kLimits);
  for (const char* id : {"a", "b", "c"}) {
    EXPECT_TRUE(queue.may_read());
    queue.add(request(id));
  }
  EXPECT_FALSE(queue.may_read());
  EXPECT_EQ(queue.begin().id, "a");
  EXPECT_TRUE(queue.may_read());
}

TEST(StreamQueue, ReadsUntilTheWaitingBytesAreAsManyAsMayBe) {
  StreamQueue queue(memory(), kLimits);
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
  StreamQueue queue(memory(), kLimits);
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
  StreamQueue queue(memory(), kLimits);
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
  StreamQueue queue(memory(), kLimits);
  queue.add(request("a"));
  queue.add(request("b"));
  EXPECT_EQ(queue.begin().id, "a");
  EXPECT_FALSE(queue.may_begin());
  queue.answer(1, reply("done"));
  EXPECT_EQ(queue.begin().id, "b");
}

TEST(StreamQueue, KeepsTheLatestProgressOnly) {
  StreamQueue queue(memory(), kLimits);
  queue.add(request("a"));
  queue.begin();
  for (const char* event : {"one", "two", "three"}) queue.progress(1, reply(event));
  EXPECT_EQ(text_of(queue.next_reply().bytes), "three");
  EXPECT_FALSE(queue.has_reply());
}

TEST(StreamQueue, SendsNoProgressOfARequestThatHasEnded) {
  StreamQueue queue(memory(), kLimits);
  queue.add(request("a"));
  queue.add(request("b"));
  queue.begin();
  queue.progress(1, reply("still waiting to be sent"));
  queue.answer(1, reply("done"));
  queue.progress(1, reply("too late"));
  EXPECT_EQ(text_of(queue.next_reply().bytes), "done");
  EXPECT_FALSE(queue.has_reply());
  queue.begin();
  queue.progress(1, reply("much too late"));
  EXPECT_FALSE(queue.has_reply());
}

TEST(StreamQueue, TakesOneAnswerForARequest) {
  StreamQueue queue(memory(), kLimits);
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
  StreamQueue queue(memory(), kLimits);
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
  StreamQueue queue(memory(), kLimits);
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

/// Takes and writes the next reply.
std::string write_next(StreamQueue& queue) {
  const StreamQueue::Next next = queue.next_reply();
  std::string text = text_of(next.source ? next.source->next() : next.bytes);
  queue.written();
  return text;
}

TEST(StreamQueue, TheRepliesOfASourceFollowTheirAnswerWithNothingInBetween) {
  StreamQueue queue(memory());
  for (const char* id : {"a", "b"}) queue.add(request(id));
  queue.begin();
  queue.answer(1, reply("a"), std::make_shared<Meshes>(2));
  queue.begin();
  EXPECT_EQ(write_next(queue), "a");
  EXPECT_EQ(write_next(queue), "mesh 0");
  queue.progress(2, reply("progress"));
  EXPECT_EQ(write_next(queue), "mesh 1");
  EXPECT_EQ(write_next(queue), "progress");
  EXPECT_FALSE(queue.has_reply());
}

TEST(StreamQueue, BeginsNothingWhileAsManySourcesWaitAsMay) {
  StreamQueue queue(memory(), StreamQueue::Limits{.sources = 1});
  for (const char* id : {"a", "b"}) queue.add(request(id));
  queue.begin();
  queue.answer(1, reply("a"), std::make_shared<Meshes>(1));
  EXPECT_FALSE(queue.may_begin());
  EXPECT_TRUE(queue.may_read());
  EXPECT_EQ(write_next(queue), "a");
  EXPECT_FALSE(queue.may_begin());
  EXPECT_EQ(write_next(queue), "mesh 0");
  EXPECT_TRUE(queue.may_begin());
}

TEST(StreamQueue, ThatIsClosedKeepsNoSource) {
  StreamQueue queue(memory(), StreamQueue::Limits{.sources = 1});
  queue.add(request("a"));
  queue.begin();
  const auto meshes = std::make_shared<Meshes>(2);
  queue.answer(1, reply("a"), meshes);
  queue.close();
  EXPECT_EQ(meshes.use_count(), 1);
  queue.written();
  EXPECT_TRUE(queue.idle());
}

/// A queue that may hold as much as it likes of a budget.
class StreamQueueMemory : public testing::Test {
 protected:
  static constexpr std::uint64_t kOwn = limits::kStreamMemory, kLarge = 4 * kOwn;

  /// What it takes for itself and so many bytes.
  [[nodiscard]] static std::uint64_t share(std::uint64_t bytes) { return kOwn + bytes; }

  MemoryBudget budget_{share(3 * kLarge)};
  StreamQueue queue_{budget_.try_take(kOwn)};
};

TEST_F(StreamQueueMemory, SmallMessagesCostNoMoreThanTheStream) {
  for (int i = 0; i < 8; ++i) queue_.add(request("a", limits::kStreamSpare / 16));
  queue_.begin();
  queue_.answer(1, reply(std::string(limits::kStreamSpare / 2, 'x')));
  EXPECT_EQ(budget_.leased(), kOwn);
}

TEST_F(StreamQueueMemory, RequestsCountUntilTheyAreDecoded) {
  ASSERT_TRUE(queue_.make_room(kLarge));
  EXPECT_EQ(budget_.leased(), share(kLarge)) << "from before it is kept";
  queue_.add(request("a", kLarge));
  EXPECT_EQ(budget_.leased(), share(kLarge));
  queue_.begin();
  EXPECT_EQ(budget_.leased(), share(kLarge));
  queue_.decoded();
  EXPECT_EQ(budget_.leased(), kOwn);
}

TEST_F(StreamQueueMemory, ARequestThatIsAnsweredUnreadCountsNoMore) {
  queue_.add(request("a", kLarge));
  queue_.begin();
  queue_.answer(1, reply("refused"));
  EXPECT_EQ(budget_.leased(), kOwn);
}

TEST_F(StreamQueueMemory, HasNoRoomForARequestWhereTheBudgetHasNone) {
  const auto others = budget_.try_take(2 * kLarge);
  EXPECT_FALSE(queue_.make_room(kLarge + 1));
  EXPECT_EQ(budget_.leased(), share(2 * kLarge));
  EXPECT_TRUE(queue_.make_room(kLarge));
}

TEST_F(StreamQueueMemory, TakesNoneForRequestsOnceItIsClosed) {
  queue_.close();
  EXPECT_TRUE(queue_.make_room(4 * kLarge)) << "the request is dropped";
  EXPECT_EQ(budget_.leased(), kOwn);
}

TEST_F(StreamQueueMemory, RepliesCountUntilTheyAreWritten) {
  queue_.add(request("a"));
  queue_.begin();
  queue_.answer(1, reply(std::string(kLarge, 'x')), std::make_shared<Meshes>(1, kLarge));
  EXPECT_EQ(budget_.leased(), share(2 * kLarge));
  write_next(queue_);
  EXPECT_EQ(budget_.leased(), share(kLarge));
  write_next(queue_);
  EXPECT_EQ(budget_.leased(), kOwn);
}

TEST_F(StreamQueueMemory, RepliesThatAreMadeCountThoughThereIsNoRoom) {
  const auto others = budget_.try_take(3 * kLarge);
  queue_.add(request("a"));
  queue_.begin();
  queue_.answer(1, reply(std::string(kLarge, 'x')));
  EXPECT_EQ(budget_.leased(), share(4 * kLarge));
  EXPECT_EQ(budget_.left(), 0U);
  queue_.close();
  EXPECT_EQ(budget_.leased(), share(3 * kLarge));
}

}  // namespace
}  // namespace remeshd
