#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "server/session/tenants.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

/// Tenants whose limits a test sets before `start`.
class SessionAdmission : public testing::Test {
 protected:
  ~SessionAdmission() override { fake_.open_gate(); }

  void start() {
    tenants_ = std::make_unique<Tenants>(
        fake_.engine(), limits_,
        [](const std::string& /*tenant*/) { return std::make_unique<Store>(); });
  }
  /// Makes another model each time.
  Answer make(const std::string& tenant = "", std::uint32_t nodes = 100) {
    Answer answer;
    const double length = 10.0 + ++made_;
    tenants_->open(tenant);
    Session& session = tenants_->of(tenant);
    const auto read = [this, length, nodes]() -> Command {
      ++read_;
      return CreateCommand{.source = model_of({block("plate", length, 40, 10)}),
                           .options = {.nodes = nodes}};
    };
    const Listener listener = answer.listener();
    catching([&] { session.make(session.admit(), read, listener); }, listener.failed);
    return answer;
  }

  /// Waits until all but `open` have their answer, 10 s at most.
  static void wait_for_answers(const std::vector<Answer>& answers, std::ptrdiff_t open) {
    const auto unanswered = [&] {
      return std::ranges::count_if(answers, [](const Answer& a) { return a.answers() == 0; });
    };
    for (int k = 0; k < 10000 && unanswered() > open; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(unanswered(), open);
  }

  FakeEngine fake_;
  SessionLimits limits_;
  std::unique_ptr<Tenants> tenants_;
  std::atomic<int> read_ = 0;
  int made_ = 0;
};

TEST_F(SessionAdmission, WhatCannotBeComputedNowIsRefusedUnread) {
  limits_.workers = 1;
  limits_.queue = 1;
  start();
  fake_.close_gate();
  std::vector<Answer> accepted{make()};
  ASSERT_TRUE(fake_.wait_at_gate(1));
  int busy = 0;
  for (int k = 0; k < 200; ++k) {
    const Answer answer = make();
    if (answer.answers() > 0 && answer.error().reason == "BUSY") {
      EXPECT_GT(answer.error().retry_after, 0);
      ++busy;
    } else {
      accepted.push_back(answer);
    }
  }
  EXPECT_GE(busy, 150);  // but for a few that may be answered by what is there
  // One of these would find a place in the queue if it was prepared after the first had ended.
  wait_for_answers(accepted, 2);
  fake_.open_gate();
  int revisions = 0;
  for (const Answer& answer : accepted) revisions += answer.error().reason.empty() ? 1 : 0;
  EXPECT_EQ(revisions, 2);
  EXPECT_LE(read_, 50);
}

TEST_F(SessionAdmission, AFullQueueStillAnswersWhatIsThere) {
  limits_.workers = 1;
  limits_.queue = 0;
  start();
  const CreateCommand known{.source = model_of({block("plate", 5, 40, 10)}),
                            .options = {.nodes = 100}};
  Answer first, again;
  tenants_->of("").make(known, first.listener());
  ASSERT_TRUE(first.came());
  fake_.close_gate();
  make();
  ASSERT_TRUE(fake_.wait_at_gate(1));
  tenants_->of("").make(known, again.listener());
  EXPECT_TRUE(again.made().cached);
}

TEST_F(SessionAdmission, ATenantThatFloodsLeavesAWorkerToTheOther) {
  limits_.workers = 2;
  start();
  ASSERT_TRUE(make("b").came());
  fake_.close_gate();
  for (int k = 0; k < 10; ++k) make("a");
  ASSERT_TRUE(fake_.wait_at_gate(1));
  make("b");
  EXPECT_TRUE(fake_.wait_at_gate(2));
  EXPECT_EQ(tenants_->load().running, 2U);
}

TEST_F(SessionAdmission, WhatComputesTooLongIsStoppedAndAnswered) {
  limits_.compute = 0.02;
  start();
  fake_.close_gate();
  const Answer answer = make();
  EXPECT_EQ(answer.error().reason, "COMPUTE_LIMIT_REACHED");
  EXPECT_EQ(answer.error().kind, ErrorKind::DeadlineExceeded);
  EXPECT_TRUE(fake_.wait_stopped(1));
}

TEST_F(SessionAdmission, WhatCanNeverFitIntoTheMemoryIsRefusedForGood) {
  limits_.memory = 1 << 20;
  start();
  EXPECT_EQ(make("", 10000).error().reason, "MESH_TOO_LARGE");
  EXPECT_EQ(make("", 100).error().reason, "");
}

TEST_F(SessionAdmission, ComputationsThatDoNotFitBesideEachOtherFollowEachOther) {
  limits_.workers = 2;
  limits_.memory = 2 << 20;  // one of 1,000 nodes takes 1.5 MB
  start();
  fake_.close_gate();
  const Answer first = make("", 1000), second = make("", 1000);
  ASSERT_TRUE(fake_.wait_at_gate(1));
  EXPECT_EQ(fake_.started(), 1);
  fake_.open_gate();
  EXPECT_EQ(first.error().reason, "");
  EXPECT_EQ(second.error().reason, "");
  EXPECT_EQ(fake_.made(), 2);
}

}  // namespace
}  // namespace remeshd::test
