#include "server/admission/fair_queue.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

using std::chrono::seconds;

/// A queue at a clock that the test sets. The ids of its work are the numbers of their coming.
class FairQueueTest : public testing::Test {
 protected:
  void add(FairQueue& queue, const std::string& tenant) {
    ASSERT_GT(queue.room(tenant, now_), 0U);
    queue.add({.id = ++last_, .since = now_, .work = {.tenant = tenant}});
    now_ += std::chrono::milliseconds(1);
  }
  /// Whose work is taken; `-` where nobody may have a worker.
  std::string take(FairQueue& queue) {
    const auto entry = queue.take(now_);
    return entry ? entry->work.tenant : "-";
  }

  FairQueue::Time now_{seconds(1000)};
  WorkId last_ = 0;
};

TEST_F(FairQueueTest, OneTenantHasAllWorkersAndAllPlaces) {
  FairQueue queue(2, 3);
  for (int i = 0; i < 5; ++i) add(queue, "a");
  EXPECT_EQ(queue.room("a", now_), 0U);
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(take(queue), "-");
  EXPECT_EQ(queue.waiting(), 3U);
  EXPECT_EQ(queue.room("a", now_), 0U);
  queue.ended("a");
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(queue.room("a", now_), 1U);
}

TEST_F(FairQueueTest, WithTwoTenantsNobodyHoldsTheLastWorker) {
  FairQueue queue(3, 10);
  for (int i = 0; i < 5; ++i) add(queue, "a");
  queue.room("b", now_);  // it asked and had nothing to do in the end
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(take(queue), "-");
  add(queue, "b");
  EXPECT_EQ(take(queue), "b");
}

TEST_F(FairQueueTest, ATenantThatAskedNothingForAMinuteIsNotWaitedFor) {
  FairQueue queue(2, 10);
  queue.room("b", now_);
  for (int i = 0; i < 2; ++i) add(queue, "a");
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(take(queue), "-");
  now_ += seconds(61);
  EXPECT_EQ(take(queue), "a");
}

TEST_F(FairQueueTest, ASingleWorkerServesTenantsInTurn) {
  FairQueue queue(1, 10);
  for (int i = 0; i < 3; ++i) add(queue, "a");
  EXPECT_EQ(take(queue), "a");
  add(queue, "b");
  queue.ended("a");
  EXPECT_EQ(take(queue), "b");
  queue.ended("b");
  EXPECT_EQ(take(queue), "a");
}

TEST_F(FairQueueTest, AFreeWorkerGoesToTheTenantThatHoldsFewest) {
  FairQueue queue(3, 10);
  for (int i = 0; i < 4; ++i) add(queue, "a");
  for (int i = 0; i < 4; ++i) add(queue, "b");
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(take(queue), "b");
  EXPECT_EQ(take(queue), "a");
  queue.ended("a");
  queue.ended("a");
  EXPECT_EQ(take(queue), "a");  // holds none, where `b` holds one
}

TEST_F(FairQueueTest, WhoeverFilledThePlacesTakesNotTheOthersShares) {
  FairQueue queue(1, 4);
  for (int i = 0; i < 5; ++i) add(queue, "a");
  EXPECT_EQ(take(queue), "a");
  EXPECT_EQ(queue.room("a", now_), 0U);
  EXPECT_EQ(queue.room("b", now_), 2U);
  add(queue, "b");
  add(queue, "b");
  EXPECT_EQ(queue.room("b", now_), 0U);
  EXPECT_EQ(queue.room("a", now_), 0U);
}

TEST_F(FairQueueTest, TakesOutWhatIsWithdrawn) {
  FairQueue queue(1, 4);
  add(queue, "a");
  add(queue, "b");
  EXPECT_TRUE(queue.withdraw(1));
  EXPECT_FALSE(queue.withdraw(1));
  EXPECT_EQ(take(queue), "b");
  EXPECT_FALSE(queue.withdraw(2));
  EXPECT_EQ(queue.waiting(), 0U);
}

TEST_F(FairQueueTest, TellsWhatHasWaitedLongestOfAllTenants) {
  FairQueue queue(1, 4);
  EXPECT_FALSE(queue.oldest());
  const auto first = now_;
  add(queue, "b");
  add(queue, "a");
  EXPECT_EQ(queue.oldest(), first);
  EXPECT_FALSE(queue.take_older_than(first - seconds(1)));
  EXPECT_EQ(queue.take_older_than(first)->work.tenant, "b");
  EXPECT_EQ(queue.clear().size(), 1U);
  EXPECT_FALSE(queue.oldest());
}

}  // namespace
}  // namespace remeshd
