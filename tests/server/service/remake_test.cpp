#include "server/service/remake.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "proto/document.h"
#include "server/service/decode.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

/// A session in whose store a plate has been meshed.
class RemakingARevision : public testing::Test {
 protected:
  Made mesh(const std::string& design, const HeadRule& head) {
    const Answer answer;
    session_->make(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                                 .options = {.nodes = 100},
                                 .design = design,
                                 .head = head},
                   answer.listener());
    return answer.made();
  }

  const FakeEngine fake_;
  const StoreFolder folder_;
  const std::shared_ptr<Session> session_ = only_session(fake_.engine(), folder_.open());
};

TEST_F(RemakingARevision, HoldsNothingOnceItIsAnswered) {
  mesh("plate", {});
  remesh::v1::RemakeRevisionRequest request;
  request.set_revision("plate");
  const auto answered = std::make_shared<std::atomic<bool>>(false);
  const std::weak_ptr<MakeRequest> remaking = remake(
      *session_, request, [answered](const Made&, const auto&) { *answered = true; },
      [answered](const Error&) { *answered = true; });
  // Whoever answers lets go of it a moment later.
  for (int i = 0; i < 5000 && (!*answered || !remaking.expired()); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(*answered);
  EXPECT_TRUE(remaking.expired());
}

TEST_F(RemakingARevision, TakesTheOptionsOfItsRecipe) {
  const auto make = [&](Command command) {
    const Answer answer;
    session_->make(std::move(command), answer.listener());
    return answer.made().filed.record.id;
  };
  const auto edit = [](double dx, const OptionsPatch& options) {
    const std::string document =
        R"({"edits": [{"setFeatureParameter": {"feature": "plate", "name": "dx", "value": )" +
        std::to_string(dx) + "}}]}";
    return EditCommand{.base = "plate",
                       .edit = decode(parse_edit(document)),
                       .document = document,
                       .options = options};
  };
  const std::vector<std::string> ids{
      make(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                         .options = {.nodes = 100,
                                     .hold = 1.5,
                                     .sizing = {.edges_per_circle = 20, .min_size = 0.5}},
                         .design = "plate"}),
      make(edit(81, {.sizing = {.layers = 3, .growth = 1.5}})),
      make(edit(82, {.hold = 0.5, .sizing = {.even = true}}))};
  for (const std::string& id : ids) {
    remesh::v1::RemakeRevisionRequest request;
    request.set_revision(id);
    Awaited<Made> again;
    remake(
        *session_, request,
        [heard = again.on_value()](const Made& made, const auto&) { heard(made); },
        again.on_error());
    EXPECT_EQ(again.value().filed.record.id, id);
  }
}

TEST_F(RemakingARevision, LeavesWhatIsInNoDesignInNone) {
  remesh::v1::RemakeRevisionRequest request;
  request.set_revision(mesh("", {.file = false}).filed.record.id);
  Awaited<Made> again;
  remake(
      *session_, request,
      [heard = again.on_value()](const Made& made, const auto&) { heard(made); }, again.on_error());
  EXPECT_EQ(again.error().reason, "");
  EXPECT_EQ(again.value().filed.place.design, "");
  EXPECT_TRUE(session_->designs({}, {}).empty());
}

TEST_F(RemakingARevision, OfSeveralDesignsHasToBeToldWhich) {
  const std::string id = mesh("plate", {}).filed.record.id;
  mesh("plank", {});
  remesh::v1::RemakeRevisionRequest request;
  request.set_revision(id);
  const ErrorInfo error = error_of([&] { remake(*session_, request, {}, {}); });
  EXPECT_EQ(error.reason, "MISSING_FIELD");
  EXPECT_EQ(error.parameter, "design");
  request.set_design("plank");
  Awaited<Made> again;
  remake(
      *session_, request,
      [heard = again.on_value()](const Made& made, const auto&) { heard(made); }, again.on_error());
  EXPECT_EQ(again.value().filed.place.design, "plank");
}

}  // namespace
}  // namespace remeshd::test
