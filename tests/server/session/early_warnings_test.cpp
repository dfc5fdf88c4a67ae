#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <memory>
#include <thread>

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

/// A session whose engine is certain of a warning before it has a mesh.
class EarlyWarnings : public testing::Test {
 protected:
  static CreateCommand plate(std::vector<WarningCode> fail_on) {
    return {.source = model_of({block("plate", 80, 40, 10)}),
            .options = {.nodes = 100},
            .fail_on = std::move(fail_on)};
  }
  Answer ask(CreateCommand command) {
    Answer answer;
    session_->make(std::move(command), answer.listener());
    return answer;
  }
  static void warn(const remeshd::Run& run) {
    const Warning lost{.code = WarningCode::FaceLost, .message = "hole.wall is gone"};
    run.warn(std::array{lost});
  }

  FakeEngine fake_;
  Engine engine_ = fake_.engine();
  std::shared_ptr<Session> session_;
};

TEST_F(EarlyWarnings, ThatAreErrorsEndTheRequestBeforeThereIsAMesh) {
  engine_.make_revision = [make = engine_.make_revision](
                              const Revision* original, const ModelSource& source,
                              const MeshOptions& options, const remeshd::Run& run) {
    warn(run);
    return make(original, source, options, run);
  };
  session_ = only_session(engine_, std::make_unique<Store>());
  const ErrorInfo error = ask(plate({WarningCode::FaceLost})).error();
  EXPECT_EQ(error.reason, "WARNING_IS_ERROR");
  ASSERT_TRUE(error.warning);
  EXPECT_EQ(error.warning->message, "hole.wall is gone");
  // Those who do not mind get their mesh.
  EXPECT_FALSE(ask(plate({WarningCode::QualityLow})).made().cached);
  EXPECT_TRUE(ask(plate({})).made().cached);
  EXPECT_EQ(fake_.started(), 1) << "the first was not meshed";
}

TEST_F(EarlyWarnings, EndOnlyTheRequestsThatTakeThemForErrors) {
  engine_.make_revision = [make = engine_.make_revision](
                              const Revision* original, const ModelSource& source,
                              const MeshOptions& options, const remeshd::Run& run) {
    Revision made = make(original, source, options, run);  // waits at the gate
    warn(run);
    return made;
  };
  session_ = only_session(engine_, std::make_unique<Store>());
  fake_.close_gate();
  const Answer strict = ask(plate({WarningCode::FaceLost}));
  ASSERT_TRUE(fake_.wait_at_gate(1));
  const Answer other = ask(plate({}));
  for (int k = 0; k < 10000 && session_->load().waiting < 2; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  fake_.open_gate();
  EXPECT_EQ(strict.error().reason, "WARNING_IS_ERROR");
  EXPECT_TRUE(other.made().revision);
  EXPECT_EQ(fake_.started(), 1);
}

}  // namespace
}  // namespace remeshd::test
