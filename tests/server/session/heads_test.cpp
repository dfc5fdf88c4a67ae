#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The design `plate` with a first mesh, and what becomes of its head.
class HeadsTest : public testing::Test {
 protected:
  HeadsTest() { start(); }

  void start() { session_ = only_session(engine_, std::make_unique<Store>()); }
  void start_with_store() {
    session_.reset();  // which has the store
    session_ = only_session(engine_, folder_.open());
  }

  /// A first mesh of a plate `dx` long.
  static CreateCommand plate(double dx, std::uint32_t nodes = 100) {
    return {.source = model_of({block("plate", dx, 40, 10)}),
            .options = {.nodes = nodes},
            .design = "plate"};
  }
  static EditCommand longer(const std::string& base, double dx) {
    return {.base = base, .edit = {{SetFeatureParameter{"plate", "dx", Scalar(dx)}}}};
  }
  Answer ask(CreateCommand command) {
    Answer answer;
    session_->make(std::move(command), answer.listener());
    EXPECT_TRUE(answer.came());
    return answer;
  }
  Answer ask(EditCommand command) {
    Answer answer;
    session_->make(std::move(command), answer.listener());
    EXPECT_TRUE(answer.came());
    return answer;
  }
  /// `plate@2 of 3`: the number of the head, and how many revisions there are.
  std::string design() {
    const auto designs = session_->designs({}, {});
    if (designs.empty()) return "none";
    return designs[0].name + "@" + std::to_string(designs[0].head_number) + " of " +
           std::to_string(designs[0].revisions);
  }

  FakeEngine fake_;
  Engine engine_ = fake_.engine();
  StoreFolder folder_;
  std::shared_ptr<Session> session_;
};

TEST_F(HeadsTest, AFirstMeshOfTheSameModelTakesTheHead) {
  ask(plate(80));
  const Made finer = ask(plate(80, 200)).made();
  EXPECT_EQ(design(), "plate@2 of 2");
  EXPECT_THAT(finer.warnings, IsEmpty());
}

TEST_F(HeadsTest, AFirstMeshOfAnotherModelLeavesTheHeadAndSaysHowToMoveIt) {
  ask(plate(80));
  ask(longer("plate", 90));
  const Made other = ask(plate(85)).made();
  EXPECT_EQ(design(), "plate@2 of 3");
  EXPECT_FALSE(other.filed.head_conflict);
  ASSERT_THAT(other.warnings, SizeIs(1));
  EXPECT_EQ(other.warnings[0].code, WarningCode::HeadKept);
  EXPECT_THAT(
      other.warnings[0].message,
      HasSubstr("`remesh mesh --head` makes it the head, and so does `remesh head plate@3`"));
  // As long as it stays.
  EXPECT_THAT(ask(plate(85)).made().warnings, SizeIs(1));
}

TEST_F(HeadsTest, DescriptionsOfParametersMakeNoOtherModel) {
  CreateCommand command = plate(80);
  command.source.parameters = {{"r", 1.0}};
  ask(command);
  command.source.parameters[0].description = "of the hole";
  command.options.nodes = 200;
  EXPECT_THAT(ask(command).made().warnings, IsEmpty());
  EXPECT_EQ(design(), "plate@2 of 2");
}

TEST_F(HeadsTest, AFirstMeshTakesTheHeadWhereItIsAsked) {
  ask(plate(80));
  CreateCommand other = plate(85);
  other.head.advance = true;
  EXPECT_THAT(ask(other).made().warnings, IsEmpty());
  EXPECT_EQ(design(), "plate@2 of 2");
}

TEST_F(HeadsTest, ALostCompareAndSetIsToldAndFiledAllTheSame) {
  const std::string first = ask(plate(80)).made().filed.record.id;
  ask(longer(first, 90));
  const Made late = ask(longer(first, 95)).made();
  EXPECT_TRUE(late.filed.head_conflict);
  EXPECT_EQ(design(), "plate@2 of 3");
}

TEST_F(HeadsTest, ARequiredHeadThatIsAnotherOneFailsBeforeAnythingIsComputed) {
  const std::string first = ask(plate(80)).made().filed.record.id;
  ask(longer(first, 90));
  EditCommand late = longer(first, 95);
  late.head.require = true;
  const ErrorInfo error = ask(late).error();
  EXPECT_EQ(error.reason, "HEAD_CONFLICT");
  EXPECT_EQ(error.kind, ErrorKind::Aborted);
  EXPECT_EQ(design(), "plate@2 of 2");
  EXPECT_EQ(fake_.started(), 2);
  // Sent once more, what was done already is no conflict.
  EditCommand again = longer(first, 90);
  again.head.require = true;
  EXPECT_TRUE(ask(again).made().cached);
}

TEST_F(HeadsTest, ARevisionIsFiledInNoDesignWhereThatIsAsked) {
  start_with_store();
  const std::string first = ask(plate(80)).made().filed.record.id;
  EditCommand command = longer("plate", 90);
  command.head.file = false;
  const Filed filed = ask(command).made().filed;
  EXPECT_EQ(filed.place.design, "");
  EXPECT_EQ(filed.place.number, 0U);
  EXPECT_FALSE(filed.place.head);
  EXPECT_EQ(filed.head, "");
  EXPECT_FALSE(filed.head_conflict);
  EXPECT_TRUE(filed.durable);
  EXPECT_EQ(design(), "plate@1 of 1");
  start_with_store();
  EXPECT_EQ(session_->resolve(filed.record.id).design, "");
  EXPECT_EQ(session_->list({.unfiled = true}, {}).size(), 1U);
  // An edit of what is in none is in none too, unless it names one.
  EXPECT_EQ(ask(longer(filed.record.id, 95)).made().filed.place.design, "");
  EditCommand named = longer(filed.record.id, 95);
  named.design = "plate";
  named.head.expected = first;
  const Made found = ask(named).made();
  EXPECT_TRUE(found.cached);
  EXPECT_EQ(found.filed.place.number, 2U);
  EXPECT_EQ(design(), "plate@2 of 2");
}

TEST_F(HeadsTest, AFirstMeshMayBeInNoDesignToo) {
  CreateCommand command = plate(80);
  command.design.clear();
  command.head.file = false;
  const Filed filed = ask(command).made().filed;
  EXPECT_EQ(filed.place.design, "");
  EXPECT_EQ(design(), "none");
  EXPECT_EQ(session_->get(filed.record.id, remeshd::Run{})->record.id, filed.record.id);
}

TEST_F(HeadsTest, WhatIsInNoDesignMovesNoHead) {
  const auto refused = [&](const std::string& what, auto change) {
    CreateCommand first = plate(90);
    first.design.clear();
    first.head.file = false;
    change(first);
    EditCommand edit = longer("plate", 90);
    edit.head.file = false;
    change(edit);
    for (const ErrorInfo& error : {ask(first).error(), ask(edit).error()}) {
      EXPECT_EQ(error.reason, "OPTIONS_INVALID") << what;
      EXPECT_EQ(error.parameter, "head.file") << what;
    }
  };
  const std::string first = ask(plate(80)).made().filed.record.id;
  refused("design", [](auto& command) { command.design = "plate"; });
  refused("advance", [](auto& command) { command.head.advance = true; });
  refused("expected", [&](auto& command) { command.head.expected = first; });
  refused("require", [](auto& command) { command.head.require = true; });
  EditCommand edit = longer("plate", 90);
  edit.head = {.advance = false, .file = false};
  EditCommand of_it = longer(ask(edit).made().filed.record.id, 95);
  of_it.head.advance = true;
  EXPECT_EQ(ask(of_it).error().reason, "MISSING_FIELD");
  EXPECT_EQ(fake_.started(), 2);
  EXPECT_EQ(design(), "plate@1 of 1");
}

TEST_F(HeadsTest, AHeadIsSetToAnyRevisionOfTheDesign) {
  const std::string first = ask(plate(80)).made().filed.record.id;
  const std::string second = ask(longer("plate", 90)).made().filed.record.id;
  const Archive::HeadSet set = session_->set_head("plate@1", "", "");
  EXPECT_EQ(set.previous, second);
  EXPECT_EQ(set.design.head, first);
  EXPECT_EQ(set.design.head_number, 1U);
  session_->set_head(second, "plate", first);
  EXPECT_EQ(design(), "plate@2 of 2");
}

TEST_F(HeadsTest, AHeadIsNotSetWhereItIsNotTheExpectedOneOrTheDesignHasItNot) {
  const std::string first = ask(plate(80)).made().filed.record.id;
  const std::string second = ask(longer("plate", 90)).made().filed.record.id;
  CreateCommand elsewhere = plate(70);
  elsewhere.design = "other";
  const std::string stranger = ask(elsewhere).made().filed.record.id;
  const auto refused = [&](const std::string& revision, const std::string& in,
                           const std::string& expected) {
    return error_of([&] { session_->set_head(revision, in, expected); }).reason;
  };
  EXPECT_EQ(refused("plate@1", "", first), "HEAD_CONFLICT");
  EXPECT_EQ(refused(first, "", ""), "MISSING_FIELD");
  EXPECT_EQ(refused(stranger, "plate", ""), "REVISION_NOT_FOUND");
  EXPECT_EQ(refused(first, "nowhere", ""), "DESIGN_NOT_FOUND");
  EXPECT_EQ(refused("plate@7", "", ""), "REVISION_NOT_FOUND");
  EXPECT_EQ(session_->get("plate", {})->record.id, second);
}

TEST_F(HeadsTest, ADesignIsRemovedWithWhatNoOtherHasAndItsNumbersGoOn) {
  start_with_store();
  const std::string first = ask(plate(80)).made().filed.record.id;
  CreateCommand shared = plate(80);
  shared.design = "other";
  ask(shared);
  const std::string second = ask(longer("plate", 90)).made().filed.record.id;
  EXPECT_EQ(error_of([&] { session_->remove_design("plate", first); }).reason, "HEAD_CONFLICT");
  const Archive::DesignRemoved removed = session_->remove_design("plate", second);
  EXPECT_EQ(removed.revisions, 2U);
  EXPECT_EQ(removed.meshes_deleted, 1U);
  EXPECT_EQ(design(), "other@1 of 1");
  EXPECT_EQ(error_of([&] { session_->remove_design("plate", ""); }).reason, "DESIGN_NOT_FOUND");
  EXPECT_EQ(error_of([&] { session_->get("plate", {}); }).reason, "REVISION_NOT_FOUND");
  EXPECT_EQ(error_of([&] { session_->get(second, {}); }).reason, "REVISION_NOT_FOUND");

  start_with_store();  // the journal says so too
  EXPECT_EQ(design(), "other@1 of 1");
  EXPECT_EQ(ask(plate(80)).made().filed.place.number, 3U);
}

TEST_F(HeadsTest, AWarningThatIsListedIsAnErrorAndNothingIsFiled) {
  engine_.make_revision = [make = engine_.make_revision](
                              const Revision* original, const ModelSource& source,
                              const MeshOptions& options, const remeshd::Run& run) {
    Revision made = make(original, source, options, run);
    made.report.warnings = {{.code = WarningCode::QualityLow, .message = "low"},
                            {.code = WarningCode::FaceLost,
                             .message = "hole.wall is gone",
                             .features = {"hole"},
                             .point = Vec3{1, 2, 3}}};
    return made;
  };
  start();
  CreateCommand strict = plate(80);
  strict.fail_on = {WarningCode::FaceLost};
  const ErrorInfo error = ask(strict).error();
  EXPECT_EQ(error.reason, "WARNING_IS_ERROR");
  EXPECT_EQ(error.kind, ErrorKind::FailedPrecondition);
  EXPECT_EQ(error.message, "FACE_LOST: hole.wall is gone");
  EXPECT_EQ(error.features, FeatureIds{"hole"});
  ASSERT_TRUE(error.warning);
  EXPECT_EQ(error.warning->code, WarningCode::FaceLost);
  EXPECT_EQ(design(), "none");
  // It is let go after the answer.
  for (int k = 0; k < 10000 && session_->load().held > 0; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(session_->load().held, 0U);

  // Who does not mind gets it, and who does gets the error from the cache too.
  ask(plate(80));
  EXPECT_EQ(design(), "plate@1 of 1");
  EXPECT_EQ(ask(strict).error().reason, "WARNING_IS_ERROR");
}

TEST_F(HeadsTest, AKeptHeadThatIsAnErrorIsFoundBeforeAnythingIsComputed) {
  ask(plate(80));
  CreateCommand other = plate(85);
  other.fail_on = {WarningCode::HeadKept};
  EXPECT_EQ(ask(other).error().reason, "WARNING_IS_ERROR");
  EXPECT_EQ(design(), "plate@1 of 1");
  EXPECT_EQ(fake_.started(), 1);
}

TEST_F(HeadsTest, NamesThatLookLikeIdsAreRefused) {
  const auto reason = [&](const std::string& name) {
    CreateCommand command = plate(80);
    command.design = name;
    return ask(command).error().reason;
  };
  for (const std::string& name :
       {std::string("deadbeef"), std::string("0123456789AB"), std::string(64, 'a')})
    EXPECT_EQ(reason(name), "DESIGN_NAME_INVALID") << name;
  for (const std::string& name :
       {std::string("abcdef0"), std::string("deadbeeg"), std::string(65, 'a')})
    EXPECT_EQ(reason(name), "") << name;
}

TEST_F(HeadsTest, TheRecordTellsRootAndVersionAndOutlivesTheDaemon) {
  engine_.algorithm_version = 7;
  start_with_store();
  const Made first = ask(plate(80)).made();
  EXPECT_TRUE(first.filed.durable);
  EXPECT_EQ(first.filed.record.root, first.filed.record.id);
  EditCommand edit = longer("plate", 90);
  edit.document = R"({"edits": []})";
  const Made second = ask(edit).made();
  start_with_store();
  const RevisionRecord record = session_->describe(session_->resolve("plate"), {}).record;
  EXPECT_EQ(record, second.filed.record);
  EXPECT_EQ(record.root, first.filed.record.id);
  EXPECT_EQ(record.algorithm_version, 7U);
  EXPECT_EQ(session_->get("plate", {})->edit, edit.document);
  EXPECT_EQ(session_->get("plate@1", {})->edit, "");
  // The model of the design's first revision is known still.
  EXPECT_THAT(ask(plate(80, 200)).made().warnings, IsEmpty());
  EXPECT_EQ(design(), "plate@3 of 3");
}

TEST_F(HeadsTest, WithoutAStoreNothingIsDurable) {
  EXPECT_FALSE(ask(plate(80)).made().filed.durable);
}

}  // namespace
}  // namespace remeshd::test
