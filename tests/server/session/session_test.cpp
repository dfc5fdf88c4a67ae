#include "server/session/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;

CreateCommand command() {
  return {.source = model_of({block("plate", 80, 40, 10)}),
          .options = {.nodes = 100},
          .design = "plate"};
}

class SessionTest : public testing::Test {
 protected:
  ~SessionTest() override { fake_.open_gate(); }

  Session& start(std::unique_ptr<Store> store = std::make_unique<Store>()) {
    session_.reset();
    session_ = only_session(engine_, std::move(store));
    return *session_;
  }
  /// Whether it comes true within 10 s.
  template <typename Condition>
  static bool comes(Condition&& condition) {
    for (int k = 0; k < 10000 && !condition(); ++k) std::this_thread::sleep_for(1ms);
    return condition();
  }

  FakeEngine fake_;
  Engine engine_ = fake_.engine();
  StoreFolder folder_;
  std::shared_ptr<Session> session_;
};

TEST_F(SessionTest, EightRequestsThatWaitForOneComputationAreAnsweredByIt) {
  Session& session = start();
  fake_.close_gate();
  std::vector<Answer> answers(8);
  for (Answer& answer : answers) session.make(command(), answer.listener());
  ASSERT_TRUE(comes([&] { return session.load().waiting == answers.size(); }));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  EXPECT_EQ(session.load().running + session.load().queued, 1U);
  fake_.open_gate();
  int computed = 0;
  for (Answer& answer : answers) {
    const Made made = answer.made();
    EXPECT_EQ(made.filed.place.number, 1U);
    EXPECT_EQ(made.revision, answers[0].made().revision);
    computed += made.cached ? 0 : 1;
  }
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(fake_.started(), 1);
  EXPECT_EQ(session.load().waiting, 0U);
}

TEST_F(SessionTest, WhatIsCancelledWhileItWaitsForItsPreparationIsNotPrepared) {
  std::atomic<int> evaluated = 0;
  engine_.evaluate = [&evaluated, evaluate = engine_.evaluate](const ModelSource& source) {
    ++evaluated;
    return evaluate(source);
  };
  Session& session = start();
  std::latch free(1), done(1);
  const auto no_refusal = [](const Error& why) { ADD_FAILURE() << why.what(); };
  for (int k = 0; k < 64; ++k)
    session.later(Lane::Preparation, {.run = [&] { free.wait(); }, .refused = no_refusal});
  Answer answer;
  const MakeRequestPtr request = session.make(command(), answer.listener());
  request->cancel();
  EXPECT_EQ(answer.error().reason, "CANCELLED");
  free.count_down();
  session.later(Lane::Preparation, {.run = [&] { done.count_down(); }, .refused = no_refusal});
  done.wait();
  session_.reset();  // when every thread is at rest, so is the request's
  EXPECT_EQ(evaluated, 0);
  EXPECT_EQ(answer.answers(), 1);
}

TEST_F(SessionTest, AListenerThatThrowsOnItsRevisionHearsOfTheFailureOnce) {
  Session& session = start();
  Answer answer, next;
  Listener listener = answer.listener();
  listener.made = [](const Made&) { throw std::runtime_error("no room for the answer"); };
  session.make(command(), listener);
  EXPECT_EQ(answer.error().kind, ErrorKind::Internal);
  EXPECT_THAT(answer.error().message, testing::HasSubstr("no room for the answer"));
  EXPECT_TRUE(session.make(command(), next.listener()) && next.made().cached);
  session_.reset();
  EXPECT_EQ(answer.answers(), 1);
}

TEST_F(SessionTest, ProgressNeverFallsThoughAnotherAttemptBeginsAnew) {
  Session& session = start();
  std::vector<double> fractions;
  Answer answer;
  Listener listener = answer.listener();
  listener.progress = [&](const Progress& progress) { fractions.push_back(progress.fraction); };
  session.make(command(), listener);
  ASSERT_TRUE(answer.made().revision);
  session_.reset();
  EXPECT_GT(fractions.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(fractions)) << testing::PrintToString(fractions);
}

TEST_F(SessionTest, AListenerThatThrowsWhateverItHearsHurtsNobodyElse) {
  Session& session = start();
  fake_.close_gate();
  Answer answer;
  std::atomic<int> failures = 0;
  session.make(command(), {.progress = [](const Progress&) { throw 1; },
                           .made = [](const Made&) { throw 2; },
                           .failed =
                               [&](const Error&) {
                                 ++failures;
                                 throw 3;
                               }});
  ASSERT_TRUE(comes([&] { return session.load().waiting == 1; }));
  session.make(command(), answer.listener());
  ASSERT_TRUE(comes([&] { return session.load().waiting == 2; }));
  fake_.open_gate();
  EXPECT_TRUE(answer.made().revision);
  session_.reset();
  EXPECT_EQ(failures, 1);
}

TEST_F(SessionTest, ARevisionThatEverybodyGaveUpAtTheLastMomentLeavesMemory) {
  MakeRequestPtr request;
  std::atomic<bool> given = false;
  // It is asked for the memory of what is done and is taken into memory.
  engine_.memory_blocks = [&, blocks = engine_.memory_blocks](const Revision& revision) {
    while (!given) std::this_thread::yield();
    request->cancel();
    return blocks(revision);
  };
  Session& session = start();
  Answer answer;
  request = session.make(command(), answer.listener());
  given = true;
  EXPECT_EQ(answer.error().reason, "CANCELLED");
  ASSERT_TRUE(comes([&] { return session.load().running == 0; }));
  EXPECT_EQ(fake_.made(), 1);
  EXPECT_EQ(session.load().held, 0U);
  EXPECT_EQ(session.load().held_bytes, 0U);
  EXPECT_EQ(session.load().revisions, 0U);
}

TEST_F(SessionTest, ARevisionThatCouldNotBeFiledLeavesMemory) {
  engine_.image_of = [](const Revision&) -> StoredArrays { throw error::internal("test", "no"); };
  Session& session = start(folder_.open());
  Answer answer;
  session.make(command(), answer.listener());
  EXPECT_EQ(answer.error().kind, ErrorKind::Internal);
  ASSERT_TRUE(comes([&] { return session.load().running == 0; }));
  EXPECT_EQ(session.load().held, 0U);
  EXPECT_EQ(session.load().revisions, 0U);
}

class DamagedCopy : public SessionTest {
 protected:
  DamagedCopy() {
    Answer answer;
    start(folder_.open()).make(command(), answer.listener());
    EXPECT_EQ(answer.made().filed.place.number, 1U);
    session_.reset();
    folder_.damage_objects();
  }
  /// Whether the store's copy can be read by who has nothing in memory.
  bool intact() {
    session_.reset();  // it has the store
    start(folder_.open());
    try {
      return session_->cache().find(session_->resolve("plate").id, {}) != nullptr;
    } catch (const Error&) {
      return false;
    }
  }
};

TEST_F(DamagedCopy, IsSeen) { EXPECT_FALSE(intact()); }

TEST_F(DamagedCopy, IsHealedByTheNextWaiterWhereTheFirstOneFails) {
  std::atomic<int> written = 0;
  engine_.image_of = [&, image_of = engine_.image_of](const Revision& revision) {
    if (++written == 1) throw error::internal("test", "the first one fails");
    return image_of(revision);
  };
  Session& session = start(folder_.open());
  fake_.close_gate();
  Answer first, second;
  session.make(command(), first.listener());
  ASSERT_TRUE(comes([&] { return session.load().waiting == 1; }));
  session.make(command(), second.listener());
  ASSERT_TRUE(comes([&] { return session.load().waiting == 2; }));
  fake_.open_gate();
  EXPECT_EQ(first.error().kind, ErrorKind::Internal);
  EXPECT_EQ(second.made().filed.place.number, 1U);
  EXPECT_TRUE(intact());
}

TEST_F(DamagedCopy, IsHealedFromMemoryWhereWhoeverHadItMadeAnewGaveUp) {
  MakeRequestPtr request;
  std::atomic<bool> given = false, gave_up = false;
  engine_.memory_blocks = [&, blocks = engine_.memory_blocks](const Revision& revision) {
    while (!given) std::this_thread::yield();
    if (!gave_up.exchange(true)) request->cancel();
    return blocks(revision);
  };
  Session& session = start(folder_.open());
  Answer first, second;
  request = session.make(command(), first.listener());
  given = true;
  EXPECT_EQ(first.error().reason, "CANCELLED");
  ASSERT_TRUE(comes([&] { return session.load().running == 0; }));
  ASSERT_EQ(session.load().held, 1U);
  session.make(command(), second.listener());
  EXPECT_TRUE(second.made().cached);
  EXPECT_TRUE(intact());
}

class NodeLimit : public SessionTest {
 protected:
  NodeLimit() { start_limited(); }
  void start_limited() {
    session_.reset();
    session_ = only_session(engine_, std::make_unique<Store>(), {.max_nodes = 1000});
  }
  HeldRevisionPtr make_plate() {
    Answer answer;
    session_->make(command(), answer.listener());
    return answer.made().revision;
  }
  static ModelEdit longer(double dx) {
    return {{SetFeatureParameter{.feature = "plate", .name = "dx", .value = Scalar(dx)}}};
  }
  ErrorInfo refused(CreateCommand create) {
    Answer answer;
    session_->make(std::move(create), answer.listener());
    return answer.error();
  }
  ErrorInfo refused(EditCommand edit) {
    Answer answer;
    session_->make(std::move(edit), answer.listener());
    return answer.error();
  }
};

TEST_F(NodeLimit, HoldsForACountASizeAndAnInheritedEdgeLengthBeforeAnythingIsComputed) {
  ASSERT_TRUE(make_plate());
  const ModelSource plate = command().source;
  const std::vector<ErrorInfo> errors{
      refused(CreateCommand{.source = plate, .options = {.nodes = 1001}}),
      refused(CreateCommand{.source = plate, .options = {.size = 0.1}}),
      refused(EditCommand{.base = "plate", .edit = longer(1e9)}),
      refused(EditCommand{.base = "plate", .edit = longer(81), .options = {.nodes = 1001}}),
      error_of([&] { session_->validate(plate, {.nodes = 1001}, {}); }),
      error_of([&] { session_->validate(plate, {.size = 0.1}, {}); }),
      error_of([&] { session_->validate_edit("plate", longer(1e9), {}, {}); }),
      error_of([&] { session_->validate_edit(plate, longer(1e9), {.size = 2.5}, {}); })};
  for (const ErrorInfo& error : errors) {
    EXPECT_EQ(error.reason, "MESH_TOO_LARGE");
    EXPECT_EQ(error.kind, ErrorKind::InvalidArgument);
    EXPECT_THAT(error.message, testing::HasSubstr("limit of 1000"));
    EXPECT_FALSE(error.retry_after);
  }
  EXPECT_EQ(fake_.started(), 1);
}

TEST_F(NodeLimit, ReachesTheComputationToo) {
  std::uint32_t given = 0;
  engine_.make_revision = [&, make = engine_.make_revision](
                              const Revision* original, const ModelSource& source,
                              const MeshOptions& options, const remeshd::Run& run) {
    given = run.max_nodes;
    return make(original, source, options, run);
  };
  start_limited();
  ASSERT_TRUE(make_plate());
  EXPECT_EQ(given, 1000U);
}

TEST_F(NodeLimit, AnEditIsValidatedWithTheEdgeLengthOfItsBase) {
  std::vector<MeshOptions> checked;
  engine_.check_node_limit = [&](const Revision*, const FeatureModel&, const MeshOptions& options,
                                 const remeshd::Run&) {
    checked.push_back(options);
    return 0.0;
  };
  start_limited();
  ASSERT_TRUE(make_plate());
  EXPECT_EQ(session_->validate_edit("plate", longer(81), {}, {}).summary.cells, 1U);
  ASSERT_EQ(checked.size(), 2U);
  EXPECT_EQ(checked[0].nodes, 100U);
  EXPECT_FALSE(checked[1].nodes || checked[1].size) << "neither means: as the base";
}

}  // namespace
}  // namespace remeshd::test
