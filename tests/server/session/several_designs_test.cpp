#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A plate that is the first revision of two designs, `anna` and `bert`, and edits of it by its id.
class ARevisionInSeveralDesigns : public testing::Test {
 protected:
  ARevisionInSeveralDesigns() {
    for (const char* name : {"anna", "bert"}) id_ = mesh(name);
  }

  std::string mesh(const std::string& design) {
    return ask(CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                             .options = {.nodes = 100},
                             .design = design})
        .made()
        .filed.record.id;
  }
  static EditCommand longer(const std::string& base) {
    return {.base = base, .edit = {{SetFeatureParameter{"plate", "dx", Scalar(90.0)}}}};
  }
  Answer ask(Command command) {
    Answer answer;
    session_->make(std::move(command), answer.listener());
    EXPECT_TRUE(answer.came());
    return answer;
  }
  /// `anna@1 bert@2`: the heads of all designs.
  std::string heads() {
    std::string text;
    for (const DesignRecord& design : session_->designs({}, {}))
      text += (text.empty() ? "" : " ") + design.name + "@" + std::to_string(design.head_number);
    return text;
  }

  FakeEngine fake_;
  StoreFolder folder_;
  std::shared_ptr<Session> session_ = only_session(fake_.engine(), folder_.open());
  std::string id_;
};

TEST_F(ARevisionInSeveralDesigns, IsNotEditedByItsIdWhereNothingSaysInWhich) {
  const ErrorInfo error = ask(longer(id_)).error();
  EXPECT_EQ(error.kind, ErrorKind::InvalidArgument);
  EXPECT_EQ(error.reason, "MISSING_FIELD");
  EXPECT_EQ(error.parameter, "design");
  EXPECT_EQ(error.hint, id_.substr(0, 12) + " stands in `anna`, `bert`: name one, or give anna@1 " +
                            "in place of the id");
  EditCommand other = longer(id_);
  other.last_design = "carl";
  EXPECT_EQ(ask(other).error().reason, "MISSING_FIELD");
  EXPECT_EQ(heads(), "anna@1 bert@1");
  EXPECT_EQ(fake_.started(), 1);
}

TEST_F(ARevisionInSeveralDesigns, IsEditedInTheOneThatIsNamed) {
  EditCommand named = longer(id_);
  named.design = "bert";
  EXPECT_EQ(ask(named).made().filed.place.design, "bert");
  EXPECT_EQ(heads(), "anna@1 bert@2");
  EXPECT_EQ(ask(longer("anna@1")).made().filed.place.design, "anna");
}

TEST_F(ARevisionInSeveralDesigns, IsEditedInTheOneThatWasWorkedOnLast) {
  EditCommand next = longer(id_);
  next.last_design = "bert";
  EXPECT_EQ(ask(next).made().filed.place.design, "bert");
  EXPECT_EQ(heads(), "anna@1 bert@2");
}

TEST_F(ARevisionInSeveralDesigns, IsEditedInNoneWhereThatIsAsked) {
  EditCommand loose = longer(id_);
  loose.head.file = false;
  EXPECT_EQ(ask(loose).made().filed.place.design, "");
}

TEST_F(ARevisionInSeveralDesigns, IsTakenForThatOfTheOnlyOneLeft) {
  session_->remove("anna@1", true);
  EditCommand next = longer(id_);
  next.last_design = "anna";
  EXPECT_EQ(ask(next).made().filed.place.design, "bert");
}

TEST_F(ARevisionInSeveralDesigns, IsToldWithAFewOfThem) {
  for (const char* name : {"carl", "dora", "emil"}) mesh(name);
  const std::string hint = ask(longer(id_)).error().hint;
  EXPECT_THAT(hint, HasSubstr("`anna`, `bert`, `carl` and 2 more"));
  EXPECT_THAT(hint, Not(HasSubstr("dora")));
}

}  // namespace
}  // namespace remeshd::test
