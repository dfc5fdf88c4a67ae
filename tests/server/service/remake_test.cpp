#include "server/service/remake.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
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

/// `plate@1` to `plate@3`, the head, of yesterday's algorithm.
class RemakingOfYesterday : public testing::Test {
 protected:
  RemakingOfYesterday() {
    open(13);
    make(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                       .options = {.nodes = 100},
                       .design = "plate"});
    for (const int dx : {81, 82}) {
      const std::string document =
          R"({"edits": [{"setFeatureParameter": {"feature": "plate", "name": "dx", "value": )" +
          std::to_string(dx) + "}}]}";
      make(
          EditCommand{.base = "plate", .edit = decode(parse_edit(document)), .document = document});
    }
    open(14);
  }

  void open(std::uint32_t version) {
    session_.reset();  // which has the store
    Engine engine = fake_.engine();
    engine.algorithm_version = version;
    session_ = only_session(std::move(engine), folder_.open());
  }
  void make(Command command) {
    const Answer answer;
    session_->make(std::move(command), answer.listener());
    static_cast<void>(answer.made());
  }
  Awaited<Made> begin(const remesh::v1::RemakeRevisionRequest& request) {
    Awaited<Made> again;
    remake(
        *session_, request,
        [heard = again.on_value()](const Made& made, const auto&) { heard(made); },
        again.on_error());
    return again;
  }
  Filed remade(const std::string& revision, const HeadRule& rule = {},
               const std::string& design = "") {
    return begin(request_for(revision, rule, design)).value().filed;
  }
  static remesh::v1::RemakeRevisionRequest request_for(const std::string& revision,
                                                       const HeadRule& rule,
                                                       const std::string& design = "") {
    remesh::v1::RemakeRevisionRequest request;
    request.set_revision(revision);
    request.set_design(design);
    if (rule.advance) request.mutable_head()->set_advance(*rule.advance);
    if (!rule.expected.empty()) request.mutable_head()->set_expected(rule.expected);
    if (rule.require) request.mutable_head()->set_require(true);
    return request;
  }
  std::string id(const std::string& name) { return session_->resolve(name).id; }

  FakeEngine fake_;
  const StoreFolder folder_;
  std::shared_ptr<Session> session_;
};

TEST_F(RemakingOfYesterday, MovesTheHeadUnaskedWhereThatIsRemade) {
  const Filed filed = remade("plate@3");
  EXPECT_TRUE(filed.place.head);
  EXPECT_FALSE(filed.head_conflict);
  EXPECT_EQ(id("plate"), filed.record.id);
}

TEST_F(RemakingOfYesterday, LeavesTheHeadUnaskedWhereAnotherIsRemade) {
  const std::string head = id("plate");
  for (const char* name : {"plate@1", "plate@2"}) {
    const Filed filed = remade(name);
    EXPECT_FALSE(filed.place.head) << name;
    EXPECT_FALSE(filed.head_conflict) << name;
    EXPECT_EQ(id("plate"), head) << name;
  }
  session_->set_head("plate@1", "", "");
  EXPECT_EQ(id("plate"), remade("plate@1").record.id) << "a first mesh too";
}

TEST_F(RemakingOfYesterday, ReplacesTheHeadWhereAsked) {
  for (const char* name : {"plate@2", "plate@1"}) {
    const Filed filed = remade(name, {.advance = true});
    EXPECT_FALSE(filed.head_conflict) << name;
    EXPECT_EQ(id("plate"), filed.record.id) << name;
  }
}

TEST_F(RemakingOfYesterday, ReplacesNoHeadThatBecameOneMeanwhile) {
  fake_.close_gate();
  const Awaited<Made> again = begin(request_for("plate@2", {.advance = true}));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  session_->set_head("plate@1", "", "");
  fake_.open_gate();
  EXPECT_TRUE(again.value().filed.head_conflict);
  EXPECT_EQ(id("plate"), id("plate@1"));
}

TEST_F(RemakingOfYesterday, GoesByTheHeadThatIsExpected) {
  const std::string head = id("plate");
  EXPECT_TRUE(remade("plate@2", {.expected = id("plate@1")}).head_conflict);
  EXPECT_EQ(id("plate"), head);
  const ErrorInfo error =
      begin(request_for("plate@1", {.expected = id("plate@1"), .require = true})).error();
  EXPECT_EQ(error.reason, "HEAD_CONFLICT");
  EXPECT_EQ(id("plate"), head);
  EXPECT_TRUE(remade("plate@2", {.expected = head}).place.head);
}

TEST_F(RemakingOfYesterday, MakesNoAncestorTheHeadOfADesignWithoutOne) {
  session_.reset();
  std::filesystem::remove_all(folder_.path() / "packs");
  open(14);
  const Filed filed = remade("plate@3", {}, "anew");
  EXPECT_EQ(filed.place.number, 3U) << "its two ancestors are made anew too";
  EXPECT_FALSE(filed.head_conflict);
  EXPECT_EQ(id("anew"), filed.record.id);
}

}  // namespace
}  // namespace remeshd::test
