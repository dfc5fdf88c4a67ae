#include "server/admission/pool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <latch>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace remeshd {
namespace {

const auto kFailIfRefused = [](const Error& error) { ADD_FAILURE() << error.what(); };

/// Keeps a pool's only worker busy until `open`. The worker may still be on its way out of it when
/// the blocker is gone, so it has a share of its own in the gates.
class Blocker {
 public:
  explicit Blocker(Pool& pool) {
    pool.submit({.run =
                     [gates = gates_] {
                       gates->started.count_down();
                       gates->released.wait();
                     },
                 .refused = kFailIfRefused});
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
  for (int i = 0; i < 50; ++i)
    pool.submit({.run = [&order, i] { order.push_back(i); }, .refused = kFailIfRefused});
  pool.submit({.run = [&] { last.set_value(); }, .refused = kFailIfRefused});
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
    pool.submit({.run =
                     [&] {
                       all_three.arrive_and_wait();
                       ++done;
                     },
                 .refused = kFailIfRefused});
  all_three.wait();
  pool.shutdown();
  EXPECT_EQ(done, 3);
}

TEST(Pool, RefusesWhatDoesNotFitIntoItsQueueWithADelay) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60});
  Blocker blocker(pool);
  for (int i = 0; i < 2; ++i)
    pool.submit({.run = [] {}, .refused = [](const Error&) {}});  // the end comes first
  try {
    pool.submit({.run = [] {}, .refused = kFailIfRefused});
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
  pool.submit({.run = [&] { ran.set_value(); }, .refused = kFailIfRefused});
  ran.get_future().wait();
}

TEST(Pool, AWithdrawnJobNeitherRunsNorIsRefused) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60});
  Blocker blocker(pool);
  const auto id =
      pool.submit({.run = [] { ADD_FAILURE() << "it ran"; }, .refused = kFailIfRefused});
  EXPECT_TRUE(pool.withdraw(id));
  EXPECT_FALSE(pool.withdraw(id));
  EXPECT_EQ(pool.queued(), 0U);
  blocker.open();
}

TEST(Pool, RefusesWhatWaitsTooLong) {
  Pool pool({.workers = 1, .queue = 2, .wait = 0.02});
  Blocker blocker(pool);
  std::promise<std::string> reason;
  pool.submit({.run = [] { ADD_FAILURE() << "it ran"; },
               .refused = [&](const Error& error) { reason.set_value(error.info().reason); }});
  EXPECT_EQ(reason.get_future().get(), "WAITED_TOO_LONG");
  blocker.open();
}

TEST(Pool, TellsWorkThatTakesTooLongOnceAndLetsItEnd) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60, .compute = 0.02});
  std::promise<std::string> overdue;
  auto told = overdue.get_future().share();
  std::promise<void> ended;
  pool.submit({.run =
                   [&] {
                     told.wait();
                     ended.set_value();
                   },
               .refused = kFailIfRefused,
               .overdue = [&](const Error& error) { overdue.set_value(error.info().reason); }});
  EXPECT_EQ(told.get(), "COMPUTE_LIMIT_REACHED");
  ended.get_future().wait();
}

TEST(Pool, TellsHowLongEachWorkWaited) {
  std::vector<double> waited;
  Pool pool({.workers = 1, .waited = [&](double s) { waited.push_back(s); }});
  Blocker blocker(pool);
  std::promise<void> last;
  pool.submit({.run = [&] { last.set_value(); }, .refused = kFailIfRefused});
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  blocker.open();
  last.get_future().wait();
  ASSERT_EQ(waited.size(), 2U);
  EXPECT_GE(waited[0], 0);
  EXPECT_GE(waited[1], 0.005);
}

TEST(Pool, ATenantThatFloodsLeavesTheOthersTheLastWorker) {
  Pool pool({.workers = 2, .queue = 10, .wait = 60});
  static_cast<void>(pool.room("b"));  // active, so that `a` may not have both
  std::latch open(1);
  std::latch started(1);
  std::atomic<int> running = 0;
  for (int i = 0; i < 4; ++i)
    pool.submit({.tenant = "a",
                 .run =
                     [&] {
                       if (++running == 1) started.count_down();
                       open.wait();
                       --running;
                     },
                 .refused = kFailIfRefused});
  started.wait();
  std::promise<int> beside;
  pool.submit(
      {.tenant = "b", .run = [&] { beside.set_value(running); }, .refused = kFailIfRefused});
  EXPECT_EQ(beside.get_future().get(), 1);
  open.count_down();
  while (pool.running() + pool.queued() > 0) std::this_thread::yield();
}

TEST(Pool, ShutdownRefusesWhatWaitsAndLetsFinishWhatRuns) {
  Pool pool({.workers = 1, .queue = 2, .wait = 60});
  Blocker blocker(pool);
  std::string reason;
  pool.submit({.run = [] { ADD_FAILURE() << "it ran"; },
               .refused =
                   [&](const Error& error) {
                     reason = error.info().reason;
                     blocker.open();
                   }});
  pool.shutdown();
  EXPECT_EQ(reason, "SHUTTING_DOWN");
  EXPECT_EQ(pool.running(), 0U);
  EXPECT_THROW(pool.submit({.run = [] {}, .refused = kFailIfRefused}), Error);
}

TEST(Pool, RunsOnWhateverAJobThrows) {
  Pool pool({.workers = 1, .queue = 10, .wait = 60});
  pool.submit({.run = [] { throw std::runtime_error("a job"); }, .refused = kFailIfRefused});
  pool.submit({.run = [] { throw 1; }, .refused = kFailIfRefused});
  std::promise<void> ran;
  pool.submit({.run = [&] { ran.set_value(); }, .refused = kFailIfRefused});
  ran.get_future().wait();
}

TEST(Pool, RunsItsWorkAtTheNicenessGiven) {
  const int own = ::getpriority(PRIO_PROCESS, 0);
  for (const int niceness : {0, 3}) {
    Pool pool({.workers = 1, .niceness = niceness});
    std::promise<int> found;
    pool.submit({.run = [&] { found.set_value(::getpriority(PRIO_PROCESS, 0)); },
                 .refused = kFailIfRefused});
    EXPECT_EQ(found.get_future().get(), std::min(19, own + niceness));
  }
}

TEST(Pool, RefusesOnWhateverARefusalThrows) {
  Pool pool({.workers = 1, .queue = 10, .wait = 0.02});
  Blocker blocker(pool);
  std::promise<void> refused;
  pool.submit(
      {.run = [] {}, .refused = [](const Error&) { throw std::runtime_error("a refusal"); }});
  pool.submit({.run = [] {}, .refused = [&](const Error&) { refused.set_value(); }});
  refused.get_future().wait();
  pool.submit({.run = [] {},
               .refused =
                   [&](const Error&) {
                     blocker.open();
                     throw std::runtime_error("a refusal at the end");
                   }});
  pool.shutdown();
}

}  // namespace
}  // namespace remeshd
