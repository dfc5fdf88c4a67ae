#include "engine/remesh/strategies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "engine/remesh/steps.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

bool always(const Problem&, const Attempt*) { return true; }

/// A first mesh, of a block.
class AProblem : public testing::Test {
 protected:
  AProblem() {
    modified_.source = test::one_feature(test::block("block", 1, 1, 1));
    modified_.model = evaluate(modified_.source);
  }

  Revision modified_;
  const Problem problem_{Revision::none(), modified_, {.sizes = 1}, kRun};
};

using Judge = AProblem;

/// The verdict on a valid mesh with so many tets at the interface that could not be cleaned up.
std::string reason(const Problem& problem, const Strategy& how, std::uint32_t bad) {
  Attempt attempt(how.name);
  Candidate mesh;
  mesh.verification.valid = true;
  mesh.bad_at_interface = bad;
  attempt.mesh = std::move(mesh);
  judge(how, problem, attempt);
  return attempt.reason;
}

TEST_F(Judge, TakesAValidMesh) {
  for (const Strategy& how : strategies()) EXPECT_EQ(reason(problem_, how, 0), "") << how.name;
}

TEST_F(Judge, LeavesBadTetsAtTheInterfaceToALargerPatch) {
  for (const Strategy& how : strategies())
    if (how.reach == 4 || how.reach == 6) {
      EXPECT_EQ(reason(problem_, how, 3),
                "3 tets beside what stays of the base could not be cleaned up")
          << how.name;
    }
}

TEST_F(Judge, TakesBadTetsAtTheInterfaceWhereNoLargerPatchWillBeTried) {
  for (const Strategy& how : strategies())
    if (how.reuse != Reuse::Mesh && how.reach != 4 && how.reach != 6) {
      EXPECT_EQ(reason(problem_, how, 3), "") << how.name;
    }
}

/// An attempt with a lasting warning of its own; `reason`: why it is not taken.
Attempt attempt_with_warning(const Strategy& how, std::string reason) {
  Attempt attempt(how.name);
  attempt.warnings.push_back(
      {.code = WarningCode::NodesInserted, .message = std::string("of ") + how.name});
  if (!reason.empty())
    attempt.fault = Warning{.code = WarningCode::Fallback, .message = "a fault of " + attempt.name};
  attempt.reason = std::move(reason);
  return attempt;
}

Attempt rejected(const Strategy& how, const Problem&, const Attempt*) {
  return attempt_with_warning(how, "no good");
}
Attempt taken(const Strategy& how, const Problem&, const Attempt*) {
  return attempt_with_warning(how, "");
}
Attempt no_use(const Strategy& how, const Problem&, const Attempt*) {
  Attempt attempt = attempt_with_warning(how, "no problem for this");
  attempt.serves = false;
  return attempt;
}

std::vector<std::string> messages(const std::vector<Warning>& warnings) {
  std::vector<std::string> all;
  for (const Warning& w : warnings) all.push_back(w.message);
  return all;
}
std::vector<std::string> tried(const Report& report) {
  std::vector<std::string> all;
  for (const TriedStrategy& a : report.attempts) all.push_back(a.strategy + ": " + a.reason);
  return all;
}

using FirstTaken = AProblem;

TEST_F(FirstTaken, WarningsOfAMeshThatIsThrownAwayAreToldByNobody) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, rejected, Reuse::Nodes},
                      Strategy{MeshStrategy::Fresh, "anew", always, taken}};
  const Attempt attempt = first_taken(problem_, report, of);
  EXPECT_EQ(attempt.name, "anew");
  EXPECT_THAT(messages(attempt.warnings), ElementsAre("of anew"));
  EXPECT_THAT(report.warnings, IsEmpty());
  EXPECT_EQ(report.strategy, MeshStrategy::Fresh);
  EXPECT_THAT(tried(report), ElementsAre("near: no good"));
}

Attempt failing(const Strategy&, const Problem&, const Attempt*) {
  throw remeshd::Error({.reason = "BOUNDARY_NOT_RECOVERED", .attempts = {"TetGen: too fine"}});
}

TEST_F(FirstTaken, AnErrorTellsWhatWasTriedBeforeIt) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, rejected, Reuse::Nodes},
                      Strategy{MeshStrategy::TetGen, "last", always, failing}};
  try {
    first_taken(problem_, report, of);
    ADD_FAILURE() << "no error";
  } catch (const remeshd::Error& error) {
    EXPECT_THAT(error.info().attempts, ElementsAre("near: no good", "TetGen: too fine"));
  }
}

TEST_F(FirstTaken, WhatMadeTheMeshIsTold) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, rejected, Reuse::Nodes},
                      Strategy{MeshStrategy::Fresh, "anew", always, taken}};
  first_taken(problem_, report, of);
  EXPECT_EQ(report.taken.strategy, "anew");
  EXPECT_THAT(report.taken.reason, IsEmpty());
}

TEST_F(FirstTaken, WhyTheConnectivityCouldNotBeKeptIsTold) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Morphed, "morphed", always, rejected, Reuse::Mesh},
                      Strategy{MeshStrategy::Local, "near", always, taken, Reuse::Nodes}};
  first_taken(problem_, report, of);
  EXPECT_THAT(messages(report.warnings), ElementsAre("of morphed"));
  EXPECT_THAT(tried(report), ElementsAre("morphed: no good"));
}

TEST_F(FirstTaken, NothingIsToldOfAStrategyThatTheProblemIsNoneFor) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Morphed, "morphed", always, no_use, Reuse::Mesh},
                      Strategy{MeshStrategy::Local, "near", always, taken, Reuse::Nodes}};
  first_taken(problem_, report, of);
  EXPECT_THAT(report.warnings, IsEmpty());
  EXPECT_THAT(report.attempts, IsEmpty());
}

TEST_F(FirstTaken, TheFaultOfAMeshIsToldWithWhatTakesItsPlace) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, rejected, Reuse::Nodes},
                      Strategy{MeshStrategy::Fresh, "anew", always, taken, Reuse::Nothing, 0, false,
                               0, "meshed anew"}};
  first_taken(problem_, report, of);
  EXPECT_THAT(messages(report.warnings), ElementsAre("a fault of near; meshed anew"));
}

}  // namespace
}  // namespace remeshd
