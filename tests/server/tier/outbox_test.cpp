#include "server/tier/outbox.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <latch>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/tier/tier_error.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

class OutboxTest : public testing::Test {
 protected:
  ~OutboxTest() override { fs::remove_all(folder_); }

  void write(const std::string& name) {
    if (fails_) throw error::tier_unavailable("it is out", 1);
    const std::scoped_lock lock(mutex_);
    written_.push_back(name);
  }
  std::unique_ptr<Outbox> open() {
    return std::make_unique<Outbox>(folder_, again_,
                                    [this](const std::string& name) { write(name); });
  }
  static void wait_until_empty(const Outbox& outbox) {
    for (int i = 0; i < 1000 && outbox.size() > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(outbox.size(), 0U);
  }
  [[nodiscard]] std::ptrdiff_t marks() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  std::vector<std::string> written() {
    const std::scoped_lock lock(mutex_);
    return written_;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("remeshd-outbox-test-" + std::to_string(::getpid()));
  Outbox::Again again_ = Outbox::Again::InPlace;
  std::atomic<bool> fails_ = false;
  std::mutex mutex_;
  std::vector<std::string> written_;
};

using Names = std::vector<std::string>;

TEST_F(OutboxTest, WritesWhatWasAdded) {
  const auto outbox = open();
  for (const char* name : {"c", "a", "b"}) outbox->add(name);
  wait_until_empty(*outbox);
  EXPECT_THAT(written(), UnorderedElementsAre("a", "b", "c"));
  EXPECT_EQ(marks(), 0);
}

TEST_F(OutboxTest, WritesSeveralAtATime) {
  std::latch both(2);
  Outbox outbox(folder_, again_, [&](const std::string&) { both.arrive_and_wait(); });
  outbox.add("a");
  outbox.add("b");
  wait_until_empty(outbox);
}

TEST_F(OutboxTest, WritesNoNameTwiceAtATime) {
  std::atomic<int> at_work = 0, most = 0, times = 0;
  Outbox outbox(folder_, again_, [&](const std::string&) {
    most = std::max<int>(most, ++at_work);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    --at_work;
    ++times;
  });
  for (int i = 0; i < 20; ++i) {
    outbox.add("a");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  wait_until_empty(outbox);
  EXPECT_EQ(most, 1);
  EXPECT_GT(times, 1) << "what was added while it was written is written once more";
}

TEST_F(OutboxTest, GivesUpWhatIsRefused) {
  Outbox outbox(folder_, again_, [](const std::string&) { throw error::tier_refused(100, 413); });
  outbox.add("a");
  wait_until_empty(outbox);
  EXPECT_EQ(marks(), 0);
}

TEST_F(OutboxTest, GoesOnWhereTheLastProcessEnded) {
  fails_ = true;
  {
    const auto outbox = open();
    outbox->add("a");
    outbox->add("b");
  }
  EXPECT_EQ(marks(), 2);
  fails_ = false;
  const auto outbox = open();
  wait_until_empty(*outbox);
  EXPECT_THAT(written(), UnorderedElementsAre("a", "b"));
  EXPECT_EQ(marks(), 0);
}

TEST_F(OutboxTest, TriesAgainWhatFailed) {
  fails_ = true;
  const auto outbox = open();
  outbox->add("a");
  EXPECT_THROW(outbox->write_now("a"), Error);
  EXPECT_EQ(outbox->size(), 1U);
  fails_ = false;
  wait_until_empty(*outbox);
  EXPECT_EQ(written(), Names{"a"});
}

TEST_F(OutboxTest, TriesAgainWhateverWasThrown) {
  std::atomic<bool> fails = true;
  Outbox outbox(folder_, again_, [&](const std::string&) {
    if (fails) throw fs::filesystem_error("it is out", {});
  });
  outbox.add("a");
  EXPECT_THROW(outbox.write_now("a"), fs::filesystem_error);
  EXPECT_EQ(outbox.size(), 1U);
  fails = false;
  wait_until_empty(outbox);
}

TEST_F(OutboxTest, WritesNowWhatIsStillToBeWritten) {
  fails_ = true;
  const auto outbox = open();
  outbox->add("a");
  outbox->add("b");
  fails_ = false;
  outbox->write_now("b");
  const Names now = written();
  EXPECT_NE(std::find(now.begin(), now.end(), "b"), now.end());
  wait_until_empty(*outbox);
  outbox->write_now("b");  // it was written
  EXPECT_EQ(written().size(), 2U);
}

}  // namespace
}  // namespace remeshd::test
