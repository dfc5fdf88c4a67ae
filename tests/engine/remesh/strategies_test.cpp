#include "engine/remesh/strategies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "engine/remesh/remesh.h"
#include "engine/remesh/steps.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using test::kRun;

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
  Attempt attempt = attempt_with_warning(how, "");
  attempt.serves = false;
  return attempt;
}
Attempt too_large(const Strategy& how, const Problem&, const Attempt*) {
  Attempt attempt = attempt_with_warning(how, "too many nodes");
  attempt.serves = false;
  return attempt;
}
Attempt hopeless(const Strategy& how, const Problem&, const Attempt*) {
  Attempt attempt = attempt_with_warning(how, "flat");
  attempt.hopeless = true;
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
  const Attempt attempt = first_taken(problem_, report, of).value();
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

TEST_F(FirstTaken, WhatIsToldToBeMadeInsteadIsInTheReportThoughItIsTooLarge) {
  std::vector<std::string> told;
  const remeshd::Run run{.on_warnings = [&](std::span<const Warning> warnings) {
    for (const Warning& w : warnings) told.push_back(w.message);
  }};
  const Problem problem(problem_.parent, problem_.modified, problem_.density, run);
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, rejected, Reuse::Nodes},
                      Strategy{MeshStrategy::Local, "finer", always, too_large, Reuse::Nodes, 0,
                               true, 0, "made finer"},
                      Strategy{MeshStrategy::Fresh, "anew", always, taken, Reuse::Nothing, 0, false,
                               0, "meshed anew"}};
  first_taken(problem, report, of);
  EXPECT_THAT(messages(report.warnings),
              ElementsAre("a fault of near; made finer", "a fault of near; meshed anew"));
  EXPECT_EQ(messages(report.warnings), told);
  EXPECT_THAT(tried(report), ElementsAre("near: no good", "finer: too many nodes"));
}

TEST_F(FirstTaken, TwoHopelessAttemptsInARowEndIt) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, hopeless, Reuse::Nodes},
                      Strategy{MeshStrategy::Local, "finer", always, hopeless, Reuse::Nodes},
                      Strategy{MeshStrategy::Fresh, "anew", always, taken}};
  const ErrorInfo info = test::error_of([&] { first_taken(problem_, report, of); });
  EXPECT_EQ(info.reason, "BOUNDARY_NOT_RECOVERED");
  EXPECT_THAT(info.message, testing::HasSubstr("a fault of finer"));
  EXPECT_THAT(info.attempts, ElementsAre("near: flat", "finer: flat"));

  const std::array with_another{
      Strategy{MeshStrategy::Local, "near", always, hopeless, Reuse::Nodes},
      Strategy{MeshStrategy::Local, "finer", always, rejected, Reuse::Nodes},
      Strategy{MeshStrategy::Local, "everywhere", always, hopeless, Reuse::Nodes},
      Strategy{MeshStrategy::Fresh, "anew", always, taken}};
  EXPECT_EQ(first_taken(problem_, report, with_another).value().name, "anew");
}

/// An attempt given up before there was a mesh to find a fault with.
Attempt given_up(const Strategy& how, const Problem&, const Attempt*) {
  Attempt attempt(how.name);
  attempt.reason = "no room";
  return attempt;
}

TEST_F(FirstTaken, OfAnAttemptWithoutAFaultTheReasonIsTold) {
  Report report;
  const std::array of{Strategy{MeshStrategy::Local, "near", always, given_up, Reuse::Nodes},
                      Strategy{MeshStrategy::Fresh, "anew", always, taken, Reuse::Nothing, 0, false,
                               0, "meshed anew"}};
  first_taken(problem_, report, of);
  EXPECT_THAT(messages(report.warnings), ElementsAre("no room; meshed anew"));
}

/// An attempt whose mesh was found wrong at a place.
Attempt wrong_at(const Vec3& place) {
  Attempt attempt("local, 8 edge lengths");
  Candidate mesh;
  mesh.verification.failures = {
      {MeshFailure::NonManifoldEdge, 7, place, "at a place"},
      {MeshFailure::Volume, -1, {}, "of the whole mesh, which is at no place"}};
  attempt.mesh = std::move(mesh);
  attempt.reason = "an edge";
  return attempt;
}

/// A model that is still to be meshed.
Revision to_mesh(const ModelSource& source) {
  Revision revision;
  revision.source = source;
  revision.model = evaluate(source);
  revision.cells = build_cells(revision.model, kRun);
  return revision;
}

TEST(Refined, TheMeshIsMadeAnewWhereItWasWrongAndKeptElsewhere) {
  const ModelSource source = test::model_of({test::block("bar", 60, 10, 10)});
  const Revision base = make_revision(Revision::none(), source, {.nodes = 1500}, kRun);
  const Revision modified = to_mesh(source);
  const Problem problem(base, modified,
                        resolve_density(base, {}, modified.model, modified.cells, kRun), kRun);
  const Vec3 place{25, 0, 5};
  const Attempt failed = wrong_at(place);
  ASSERT_THAT(failed.faulty_places(), ElementsAre(place));
  const auto how = std::ranges::find(strategies(), std::string("local, refined"), &Strategy::name);
  ASSERT_NE(how, strategies().end());
  EXPECT_TRUE(how->applies(problem, &failed));
  const Attempt attempt = how->make(*how, problem, &failed);
  ASSERT_EQ(attempt.reason, "");
  const double l = base.edge_length;
  EXPECT_GT(attempt.last_resort_share, 0.02);
  EXPECT_LT(attempt.last_resort_share, 0.6);
  const auto near_place = [&](const CowVector<Vec3>& nodes) {
    int count = 0;
    nodes.for_each([&](std::size_t, const Vec3& p) { count += distance(p, place) < l ? 1 : 0; });
    return count;
  };
  const PagedMesh& mesh = attempt.candidate()->whole.mesh;
  EXPECT_GT(near_place(mesh.nodes), 2 * near_place(base.output.mesh.nodes));
  // The bar's other end is the base's.
  int kept = 0, all = 0;
  attempt.candidate()->whole.map.original_node.for_each([&](std::size_t n, std::int32_t was) {
    if (mesh.nodes[n].x > 0) return;
    ++all;
    kept += was >= 0 ? 1 : 0;
  });
  EXPECT_EQ(kept, all);
}

const Strategy& named(const std::string& name) {
  return *std::ranges::find(strategies(), name, &Strategy::name);
}

TEST(Refined, AFieldThatIsNotEvenIsRefinedInsteadOfInLargerPatches) {
  const ModelSource source = test::model_of({test::block("bar", 60, 10, 10)});
  const Revision base = make_revision(Revision::none(), source, {.nodes = 300}, kRun);
  Revision modified = to_mesh(source);
  const Attempt failed = wrong_at({25, 0, 5});
  for (const bool even : {true, false}) {
    modified.options.sizing.even = even;
    const Density density = resolve_density(base, {}, modified.model, modified.cells, kRun);
    const Problem edit(base, modified, density, kRun);
    EXPECT_EQ(named("local, 6 edge lengths").applies(edit, &failed), even);
    EXPECT_TRUE(named("local, refined").applies(edit, &failed));
  }
}

TEST(Refined, IsNothingWhereNoPlaceIsKnown) {
  const auto how = std::ranges::find(strategies(), std::string("fresh, refined"), &Strategy::name);
  ASSERT_NE(how, strategies().end());
  Revision modified;
  modified.source = test::one_feature(test::block("block", 1, 1, 1));
  modified.model = evaluate(modified.source);
  const Problem problem(Revision::none(), modified, {.sizes = 1}, kRun);
  EXPECT_FALSE(how->applies(problem, nullptr));
  const Attempt failed = wrong_at({0, 0, 0});
  EXPECT_TRUE(how->applies(problem, &failed));
  Attempt without("local, everywhere");
  without.mesh = Candidate{};
  EXPECT_FALSE(how->applies(problem, &without));
}

}  // namespace
}  // namespace remeshd
