#include "server/service/remake.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

TEST(RemakingARevision, HoldsNothingOnceItIsAnswered) {
  const FakeEngine fake;
  const StoreFolder folder;
  const auto session = only_session(fake.engine(), folder.open());
  const Answer first;
  session->make(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                              .options = {.nodes = 100},
                              .design = "plate"},
                first.listener());
  ASSERT_TRUE(first.came());

  remesh::v1::RemakeRevisionRequest request;
  request.set_revision("plate");
  const auto answered = std::make_shared<std::atomic<bool>>(false);
  const std::weak_ptr<MakeRequest> remaking = remake(
      *session, request, [answered](const Made&, const auto&) { *answered = true; },
      [answered](const Error&) { *answered = true; });
  // Whoever answers lets go of it a moment later.
  for (int i = 0; i < 5000 && (!*answered || !remaking.expired()); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(*answered);
  EXPECT_TRUE(remaking.expired());
}

TEST(RemakingARevision, LeavesWhatIsInNoDesignInNone) {
  const FakeEngine fake;
  const StoreFolder folder;
  const auto session = only_session(fake.engine(), folder.open());
  const Answer first;
  session->make(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                              .options = {.nodes = 100},
                              .head = {.file = false}},
                first.listener());
  remesh::v1::RemakeRevisionRequest request;
  request.set_revision(first.made().filed.record.id);
  Awaited<Made> again;
  remake(
      *session, request, [heard = again.on_value()](const Made& made, const auto&) { heard(made); },
      again.on_error());
  EXPECT_EQ(again.error().reason, "");
  EXPECT_EQ(again.value().filed.place.design, "");
  EXPECT_TRUE(session->designs({}, {}).empty());
}

}  // namespace
}  // namespace remeshd::test
