#include "server/tier/outbox.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/tier/tier_error.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

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
  Outbox::Again again_ = Outbox::Again::First;
  std::atomic<bool> fails_ = false;
  std::mutex mutex_;
  std::vector<std::string> written_;
};

using Names = std::vector<std::string>;

TEST_F(OutboxTest, WritesInTheOrderAdded) {
  const auto outbox = open();
  for (const char* name : {"c", "a", "b"}) outbox->add(name);
  wait_until_empty(*outbox);
  EXPECT_EQ(written(), (Names{"c", "a", "b"}));
  EXPECT_EQ(marks(), 0);
}

TEST_F(OutboxTest, GoesOnWhereTheLastProcessEnded) {
  fails_ = true;
  {
    const auto outbox = open();
    outbox->add("a");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));  // times of files tell the order
    outbox->add("b");
  }
  EXPECT_EQ(marks(), 2);
  fails_ = false;
  const auto outbox = open();
  wait_until_empty(*outbox);
  EXPECT_EQ(written(), (Names{"a", "b"}));
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

TEST_F(OutboxTest, LetsNoneOvertakeWhatFailed) {
  fails_ = true;
  const auto outbox = open();
  for (const char* name : {"a", "b", "c"}) outbox->add(name);
  std::this_thread::sleep_for(std::chrono::milliseconds(700));  // two tries at least
  fails_ = false;
  wait_until_empty(*outbox);
  EXPECT_EQ(written(), (Names{"a", "b", "c"}));
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
