#include "server/session/fetcher.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/limits.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

/// What a receiver has heard.
class Fetched : public Awaited<HeldRevisionPtr> {
 public:
  [[nodiscard]] Fetcher::Receiver receiver() const {
    return {.got = on_value(), .failed = on_error()};
  }
  [[nodiscard]] HeldRevisionPtr revision() const { return value(); }
};

/// More plates than the lane of preparations has threads; none of them is in memory.
class FetcherTest : public testing::Test {
 protected:
  static constexpr int kPlates = limits::kPreparationThreads + 2;

  FetcherTest() {
    start({});
    for (int k = 0; k < kPlates; ++k) {
      Answer answer;
      session_->make(CreateCommand{.source = model_of({block("plate", 80.0 + k, 40, 10)}),
                                   .options = {.nodes = 100}},
                     answer.listener());
      ids_.push_back(answer.made().filed.record.id);
    }
    made_ = fake_.made();
    start({.workers = 1});
  }
  ~FetcherTest() override { fake_.open_gate(); }

  void start(SessionLimits limits) {
    session_.reset();  // which has the store
    session_ = only_session(fake_.engine(), folder_.open(), std::move(limits));
  }
  /// Meshes go from the disk, but for the first `kept`.
  void lose_meshes(int kept = 0) {
    for (int k = 0; k < kept; ++k) session_->cache().set_pin(id(k), true);
    session_->cache().collect_garbage({.disk_bytes = 0});
  }
  [[nodiscard]] const std::string& id(int plate) const {
    return ids_.at(static_cast<std::size_t>(plate));
  }
  Fetched fetch(const std::string& id, const std::stop_token& stop = {}) {
    Fetched fetched;
    const auto receiver = fetched.receiver();
    session_->later(Lane::Preparation, {.run = [session = session_.get(), id, stop,
                                                receiver] { session->fetch(id, stop, receiver); },
                                        .refused = receiver.failed});
    return fetched;
  }
  bool wait_until(const std::function<bool()>& holds) const {
    for (int k = 0; k < 10000 && !holds(); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return holds();
  }
  bool wait_for_waiting(std::size_t requests) {
    return wait_until([&] { return session_->load().waiting == requests; });
  }
  bool wait_for_a_free_worker() {
    return wait_until([&] { return session_->load().running == 0; });
  }
  int made_again() const { return fake_.made() - made_; }

  FakeEngine fake_;
  const StoreFolder folder_;
  std::shared_ptr<Session> session_;
  std::vector<std::string> ids_;
  int made_ = 0;
};

TEST_F(FetcherTest, LostMeshesWaitForAWorkerWhileOthersAreLoaded) {
  lose_meshes(1);
  fake_.close_gate();
  std::vector<Fetched> lost;
  for (int k = 1; k < kPlates; ++k) lost.push_back(fetch(id(k)));
  ASSERT_TRUE(wait_for_waiting(kPlates - 1));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  EXPECT_EQ(session_->load().running, 1U);
  EXPECT_EQ(session_->load().queued, kPlates - 2U);
  EXPECT_EQ(fetch(id(0)).revision()->record.id, id(0));
  fake_.open_gate();
  for (int k = 1; k < kPlates; ++k)
    EXPECT_EQ(lost[static_cast<std::size_t>(k - 1)].revision()->record.id, id(k));
  EXPECT_EQ(session_->load().waiting, 0U);
}

TEST_F(FetcherTest, ThoseWhoWantTheSameMeshShareOneComputation) {
  lose_meshes();
  fake_.close_gate();
  std::vector<Fetched> all;
  for (int k = 0; k < 5; ++k) all.push_back(fetch(id(0)));
  ASSERT_TRUE(wait_for_waiting(5));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  EXPECT_EQ(session_->load().queued, 0U);
  fake_.open_gate();
  for (const Fetched& each : all) EXPECT_EQ(each.revision(), all[0].revision());
  EXPECT_EQ(made_again(), 1);
}

TEST_F(FetcherTest, AFullQueueRefusesWhatMustBeComputedAndNothingElse) {
  start({.workers = 1, .queue = 0});
  lose_meshes(1);
  fake_.close_gate();
  const Fetched first = fetch(id(1));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  const ErrorInfo refusal = fetch(id(2)).error();
  EXPECT_EQ(refusal.reason, "BUSY");
  EXPECT_GT(refusal.retry_after, 0);
  EXPECT_NE(fetch(id(0)).revision(), nullptr);
  fake_.open_gate();
  EXPECT_NE(first.revision(), nullptr);
  ASSERT_TRUE(wait_for_a_free_worker());
  EXPECT_NE(fetch(id(2)).revision(), nullptr) << "a refusal leaves nothing behind";
}

TEST_F(FetcherTest, WhatComputesTooLongIsStoppedAndAllHearOfIt) {
  start({.workers = 1, .compute = 0.02});
  lose_meshes();
  fake_.close_gate();
  const Fetched one = fetch(id(0)), other = fetch(id(0));
  EXPECT_EQ(one.error().reason, "COMPUTE_LIMIT_REACHED");
  EXPECT_EQ(other.error().reason, "COMPUTE_LIMIT_REACHED");
  EXPECT_TRUE(wait_for_a_free_worker());
}

TEST_F(FetcherTest, AComputationIsStoppedWhenTheLastWhoWaitsForItLeaves) {
  lose_meshes();
  fake_.close_gate();
  std::stop_source first, second;
  const Fetched one = fetch(id(0), first.get_token()), other = fetch(id(0), second.get_token());
  ASSERT_TRUE(wait_for_waiting(2));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  first.request_stop();
  EXPECT_EQ(one.error().kind, ErrorKind::Cancelled);
  EXPECT_EQ(session_->load().waiting, 1U);
  EXPECT_EQ(fake_.stopped(), 0);
  second.request_stop();
  EXPECT_EQ(other.error().kind, ErrorKind::Cancelled);
  EXPECT_TRUE(fake_.wait_stopped(1));
  fake_.open_gate();
  EXPECT_NE(fetch(id(0)).revision(), nullptr) << "the next one starts afresh";
}

TEST_F(FetcherTest, WhoHasLeftBeforeItBeginsDoesNotWait) {
  lose_meshes();
  fake_.close_gate();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(fetch(id(0), stop.get_token()).error().kind, ErrorKind::Cancelled);
  EXPECT_EQ(session_->load().waiting, 0U);
}

TEST_F(FetcherTest, AnEditOfALostBaseWaitsForTheBase) {
  lose_meshes();
  const Answer answer;
  session_->make(EditCommand{.base = id(0),
                             .edit = {{SetFeatureParameter{"plate", "dx", Scalar(90.0)}}},
                             .document = "{}"},
                 answer.listener());
  EXPECT_EQ(answer.made().filed.record.parent, id(0));
  EXPECT_EQ(made_again(), 2);
}

TEST_F(FetcherTest, AnEditThatIsCancelledWhileItsBaseIsMadeStopsThat) {
  lose_meshes();
  fake_.close_gate();
  const Answer answer;
  const MakeRequestPtr request =
      session_->make(EditCommand{.base = id(0), .edit = {}, .document = "{}"}, answer.listener());
  ASSERT_TRUE(fake_.wait_at_gate(1));
  request->cancel();
  EXPECT_EQ(answer.error().kind, ErrorKind::Cancelled);
  EXPECT_TRUE(fake_.wait_stopped(1));
  EXPECT_EQ(answer.answers(), 1);
}

TEST_F(FetcherTest, WorkOfTheOnlyWorkerMakesALostMeshItself) {
  lose_meshes();
  std::atomic<bool> done = false;
  session_->later(Lane::Computation, {.run =
                                          [&] {
                                            session_->compare(id(0), id(1), remeshd::Run{});
                                            done = true;
                                          },
                                      .refused = [](const Error&) {}});
  EXPECT_TRUE(wait_until([&] { return done.load(); }));
  EXPECT_EQ(made_again(), 2);
}

TEST_F(FetcherTest, TheEndOfTheDaemonAnswersThoseWhoWait) {
  lose_meshes();
  fake_.close_gate();
  const Fetched running = fetch(id(0)), queued = fetch(id(1));
  ASSERT_TRUE(wait_for_waiting(2));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  session_->stop();
  EXPECT_EQ(running.error().reason, "SHUTTING_DOWN");
  EXPECT_EQ(queued.error().reason, "SHUTTING_DOWN");
  EXPECT_TRUE(fake_.wait_stopped(1));
}

TEST_F(FetcherTest, WhatCannotBeMadeAgainIsToldAtOnce) {
  start({.workers = 1, .queue = 0});
  lose_meshes();
  fake_.close_gate();
  const Fetched first = fetch(id(0));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  EXPECT_EQ(fetch(std::string(64, 'f')).error().reason, "REVISION_NOT_FOUND");
}

}  // namespace
}  // namespace remeshd::test
