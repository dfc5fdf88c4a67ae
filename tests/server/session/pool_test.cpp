#include "server/session/pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <latch>
#include <memory>
#include <stdexcept>
#include <string>

namespace remeshd {
namespace {

const auto kNoRefusal = [](const Error& error) { ADD_FAILURE() << error.what(); };

/// Keeps a pool's only worker busy until `open`. The worker may still be on its way out of it when
/// the blocker is gone, so it has a share of its own in the gates.
class Blocker {
 public:
  explicit Blocker(Pool& pool) {
    pool.submit(
        [gates = gates_] {
          gates->started.count_down();
          gates->released.wait();
        },
        kNoRefusal);
    gates_->started.wait();
  }
  void open() { gates_->released.count_down(); }

 private:
  struct Gates {
    std::latch started{1}, released{1};
  };
  std::shared_ptr<Gates> gates_ = std::make_shared<Gates>();
};

TEST(Pool, RunsJobsInTheOrderOfTheirComing) {
  std::vector<int> order;
  Pool pool({.workers = 1, .queue = 100, .wait = 60});
  Blocker blocker(pool);
  std::promise<void> last;
  for (int i = 0; i < 50; ++i) pool.submit([&order, i] { order.push_back(i); }, kNoRefusal);
  pool.submit([&] { last.set_value(); }, kNoRefusal);
  EXPECT_EQ(pool.queued(), 51U);
  blocker.open();
  last.get_future().wait();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Pool, RunsAsManyAtATimeAsItHasWorkers) {
  Pool pool({.workers = 3, .queue = 10, .wait = 60});
  std::latch all_three(3);
  std::atomic<int> done = 0;
  for (int i = 0; i < 3; ++i)
    pool.submit(
        [&] {
          all_three.arrive_and_wait();
          ++done;
        },
        kNoRefusal);
  all_three.wait();
  pool.shutdown();
  EXPECT_EQ(done, 3);
}

TEST(Pool, RefusesWhatDoesNotFitIntoItsQueueWithADelay) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60});
  Blocker blocker(pool);
  for (int i = 0; i < 2; ++i) pool.submit([] {}, [](const Error&) {});  // the end comes first
  try {
    pool.submit([] {}, kNoRefusal);
    ADD_FAILURE() << "a third job was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.info().kind, ErrorKind::ResourceExhausted);
    EXPECT_EQ(error.info().reason, "BUSY");
    EXPECT_GT(error.info().retry_after, 0.0);
  }
  blocker.open();
}

TEST(Pool, WithoutAQueueAnIdleWorkerStillTakesAJob) {
  Pool pool({.workers = 1, .queue = 0, .wait = 60});
  std::promise<void> ran;
  pool.submit([&] { ran.set_value(); }, kNoRefusal);
  ran.get_future().wait();
}

TEST(Pool, AWithdrawnJobNeitherRunsNorIsRefused) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60});
  Blocker blocker(pool);
  const auto id = pool.submit([] { ADD_FAILURE() << "it ran"; }, kNoRefusal);
  EXPECT_TRUE(pool.withdraw(id));
  EXPECT_FALSE(pool.withdraw(id));
  EXPECT_EQ(pool.queued(), 0U);
  blocker.open();
}

TEST(Pool, RefusesWhatWaitsTooLong) {
  Pool pool({.workers = 1, .queue = 2, .wait = 0.02});
  Blocker blocker(pool);
  std::promise<std::string> reason;
  pool.submit([] { ADD_FAILURE() << "it ran"; },
              [&](const Error& error) { reason.set_value(error.info().reason); });
  EXPECT_EQ(reason.get_future().get(), "WAITED_TOO_LONG");
  blocker.open();
}

TEST(Pool, ShutdownRefusesWhatWaitsAndLetsFinishWhatRuns) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60});
  Blocker blocker(pool);
  std::string reason;
  pool.submit([] { ADD_FAILURE() << "it ran"; },
              [&](const Error& error) {
                reason = error.info().reason;
                blocker.open();
              });
  pool.shutdown();
  EXPECT_EQ(reason, "SHUTTING_DOWN");
  EXPECT_EQ(pool.running(), 0U);
  EXPECT_THROW(pool.submit([] {}, kNoRefusal), Error);
}

TEST(Pool, RunsOnWhateverAJobThrows) {
  Pool pool({.workers = 1, .queue = 10, .wait = 60});
  pool.submit([] { throw std::runtime_error("a job"); }, kNoRefusal);
  pool.submit([] { throw 1; }, kNoRefusal);
  std::promise<void> ran;
  pool.submit([&] { ran.set_value(); }, kNoRefusal);
  ran.get_future().wait();
}

TEST(Pool, RefusesOnWhateverARefusalThrows) {
  Pool pool({.workers = 1, .queue = 10, .wait = 0.02});
  Blocker blocker(pool);
  std::promise<void> refused;
  pool.submit([] {}, [](const Error&) { throw std::runtime_error("a refusal"); });
  pool.submit([] {}, [&](const Error&) { refused.set_value(); });
  refused.get_future().wait();
  pool.submit([] {},
              [&](const Error&) {
                blocker.open();
                throw std::runtime_error("a refusal at the end");
              });
  pool.shutdown();
}

}  // namespace
}  // namespace remeshd
