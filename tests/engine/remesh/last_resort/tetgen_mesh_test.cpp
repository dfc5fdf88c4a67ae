#include "engine/remesh/last_resort/tetgen_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/mesh/quality.h"
#include "engine/nodes/density.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::model_of;
using test::placed;

using test::kRun;

/// tool1-a with pins much finer than an edge at 5,000 nodes.
ModelSource fine_pins() {
  ModelSource model = test::case_model("tool1-a");
  test::parameter(model, "pin_radius") = 0.8;
  return model;
}

/// A model ready for TetGen.
struct Ready {
  FeatureModel model;
  CellularModel cells;
  double edge_length;
  CopyPlan plan;

  Ready(const ModelSource& source, double nodes)
      : model(evaluate(source)),
        cells(build_cells(model, kRun)),
        edge_length(edge_length_for(cells.volume, cells.area, nodes)),
        plan(FeatureModel{}, model, CopyLengths{}, kRun) {}
  [[nodiscard]] TetGenInput input() const { return {model, plan, cells, edge_length}; }
};

void expect_valid(const Candidate& c, const Ready& ready) {
  const Verification v = verify(c.whole.mesh, CowVector(c.nodes.supports), ready.cells.boundary,
                                ready.cells.volume, kRun);
  EXPECT_TRUE(v.valid) << (v.failures.empty() ? "" : v.failures.front().what);
  EXPECT_EQ(c.nodes.positions, c.whole.mesh.nodes.flat());
  EXPECT_EQ(c.verification.surface, v.surface);
  for (const std::int32_t o : c.nodes.original) EXPECT_EQ(o, -1);
}

class TetGenMeshOf : public testing::TestWithParam<test::EditCase> {};

TEST_P(TetGenMeshOf, ACaseIsValidAndOfFairQuality) {
  const Ready ready(test::case_model(GetParam().modified), 3000);
  const Candidate c = mesh_by_tetgen(ready.input(), kRun);
  expect_valid(c, ready);
  EXPECT_NEAR(c.whole.mesh.nodes.size(), 3000, 0.25 * 3000);
  const Quality quality =
      measure_quality(c.whole.mesh.nodes.flat(), c.whole.mesh.tets.flat(), kRun);
  EXPECT_GT(quality.volume_length_mean, 0.72);
  EXPECT_GT(quality.dihedral_min, 12);
}

INSTANTIATE_TEST_SUITE_P(TetGenInput, TetGenMeshOf, testing::ValuesIn(test::seven_cases()),
                         [](const auto& param) {
                           std::string name = param.param.edit;
                           std::erase(name, '-');
                           return name;
                         });

struct HardInput {
  std::string name;
  ModelSource source;
  double nodes;
};

std::vector<HardInput> hard_inputs() {
  constexpr Nature kHole = Nature::Subtractive;
  FeatureSource crossing = placed(cylinder("b", 10, 40), 0, 0, 30);
  crossing.placement.z_axis = {1.0, 0.0, 0.0};
  return {
      {"WedgeOfTenDegrees",
       model_of({test::feature(
           "w", "prism", {test::point(0.0, 0.0), test::point(60.0, 0.0), test::point(60.0, 10.58)},
           {{"height", 30.0}})}),
       1000},
      {"WallOfHalfAnEdge",
       model_of({block("b", 60, 60, 10), placed(block("fin", 60, 2, 20), 0, 0, 10)}), 1000},
      {"CrossingCylindersOfOneRadius", model_of({cylinder("a", 10, 60), crossing}), 1000},
      {"BossTangentToTheRim",
       model_of({cylinder("plate", 50, 12), placed(cylinder("boss", 10, 10), 40, 0, 12)}), 1000},
      {"HoleAlmostTouchingTheRim",
       model_of({cylinder("plate", 50, 12), placed(cylinder("hole", 10, 12), 39.95, 0, 0, kHole)}),
       1000},
      {"HolesJustMerged",
       model_of({block("b", 60, 40, 10), placed(cylinder("h1", 8, 10), -7.95, 0, 0, kHole),
                 placed(cylinder("h2", 8, 10), 7.95, 0, 0, kHole)}),
       1000},
      {"HolesAlmostMerging",
       model_of({block("b", 60, 40, 10), placed(cylinder("h1", 8, 10), -8.02, 0, 0, kHole),
                 placed(cylinder("h2", 8, 10), 8.02, 0, 0, kHole)}),
       1000},
      {"PinsFinerThanAnEdge", fine_pins(), 1000},
      {"StepMuchLowerThanAnEdge",
       model_of({block("b", 60, 40, 10), placed(block("step", 30, 20, 0.05), 0, 0, 10)}), 1000},
      {"VoidUnderAThinSkin",
       model_of({block("b", 40, 40, 40),
                 placed(test::feature("v", "sphere", {{"radius", 19.8}}), 0, 0, 20, kHole)}),
       1000},
      {"ConeWithItsApex",
       model_of({test::feature("c", "cone",
                               {{"radius_bottom", 20.0}, {"radius_top", 0.0}, {"height", 40.0}})}),
       500},
      {"FlatConeOnAStem",
       model_of(
           {block("b", 60, 60, 10), placed(cylinder("stem", 2.6, 10), 0, 0, 10),
            placed(test::feature("cap", "cone",
                                 {{"radius_bottom", 8.6}, {"radius_top", 0.0}, {"height", 2.2}}),
                   0, 0, 19)}),
       500},
      {"BallWithoutEdges", model_of({test::feature("s", "sphere", {{"radius", 20.0}})}), 500},
      {"TwentyNodes", test::case_model("tool1-a"), 20},
      {"AHundredNodes", test::case_model("tool1-a"), 100},
  };
}

class TetGenMeshOfHardInput : public testing::TestWithParam<HardInput> {};

TEST_P(TetGenMeshOfHardInput, IsValid) {
  const Ready ready(GetParam().source, GetParam().nodes);
  expect_valid(mesh_by_tetgen(ready.input(), kRun), ready);
}

INSTANTIATE_TEST_SUITE_P(TetGenInput, TetGenMeshOfHardInput, testing::ValuesIn(hard_inputs()),
                         [](const auto& param) { return param.param.name; });

TEST(TetGenInput, TellsTheTriesThatItGaveUp) {
  const FeatureSource hole = placed(cylinder("hole", 10, 12), 39.97, 0, 0, Nature::Subtractive);
  const Ready ready(model_of({cylinder("plate", 50, 12), hole}), 1000);
  const Candidate c = mesh_by_tetgen(ready.input(), kRun);
  ASSERT_FALSE(c.given_up.empty());
  EXPECT_EQ(c.given_up[0].strategy, "TetGen, facets of 1 edge length");
  EXPECT_NE(c.given_up[0].reason.find("between hole.wall and plate.wall"), std::string::npos)
      << c.given_up[0].reason;
  EXPECT_GT(c.given_up[0].seconds, 0);
}

TEST(TetGenInput, HasTheDelaunayMeshOfItsNodesForTheNextEdit) {
  const Ready ready(test::case_model("tool1-a"), 2000);
  const Candidate c = mesh_by_tetgen(ready.input(), kRun);
  for (std::int32_t n = 0; n < c.nodes.size(); ++n)
    EXPECT_EQ(c.loop.mesh.position(n), c.nodes.positions[n]);
  EXPECT_NEAR(c.delaunay.tets.size(), c.whole.mesh.tets.size(), 0.1 * c.whole.mesh.tets.size());
}

TEST(TetGenInput, GivesTheSameMeshEveryTime) {
  const Ready ready(fine_pins(), 2000);
  const Candidate a = mesh_by_tetgen(ready.input(), kRun), b = mesh_by_tetgen(ready.input(), kRun);
  EXPECT_EQ(a.whole.mesh.nodes, b.whole.mesh.nodes);
  EXPECT_EQ(a.whole.mesh.tets, b.whole.mesh.tets);
}

TEST(TetGenInput, ThatFailsSaysWhereTheMeshFailedAndWhatIsThere) {
  const Ready ready(test::case_model("tool1-a"), 1000);
  TetGenInput input = ready.input();
  input.limits.helper = "/bin/false";
  const Vec3 below_rim{41, 0, 11.9};
  Verification failed;
  failed.failures = {{MeshFailure::NonconformingFacet, 0, below_rim,
                      "a boundary facet on no model face at "
                      "(41, 0, 12)"}};
  const ErrorInfo info = test::error_of([&] { tetgen_mesh(input, failed, kRun); });
  EXPECT_EQ(test::place_of(info), "BOUNDARY_NOT_RECOVERED hole1,plate -");
  EXPECT_EQ(info.place, below_rim);
  ASSERT_EQ(info.attempts.size(), 5U);
  EXPECT_TRUE(info.attempts[1].starts_with("TetGen, facets of 0.7 edge lengths: TetGen "))
      << info.attempts[1];
  EXPECT_NE(info.message.find("(41, 0, 12), between hole1.wall and plate.top; TetGen"),
            std::string::npos)
      << info.message;
  EXPECT_NE(info.hint.find("smaller edge length"), std::string::npos) << info.hint;
}

TEST(TetGenInput, TakesNoOtherWayWhereTheClockEndsOne) {
  const Ready ready(test::case_model("tool1-a"), 1000);
  TetGenInput input = ready.input();
  input.limits.seconds = 1e-3;
  EXPECT_EQ(test::error_of([&] { mesh_by_tetgen(input, kRun); }).reason, "TETGEN_TOO_SLOW");
}

TEST(TetGenInput, StopsWhenAsked) {
  const Ready ready(test::case_model("tool1-a"), 1000);
  std::stop_source stop;
  stop.request_stop();
  remeshd::Run run;
  run.stop = stop.get_token();
  EXPECT_EQ(test::error_of([&] { tetgen_mesh(ready.input(), {}, run); }).kind,
            ErrorKind::Cancelled);
}

class RevisionByTetGen : public testing::Test {
 protected:
  static void expect_valid(const Revision& r) {
    const Verification v =
        verify(r.output.mesh, r.delaunay_state->supports, r.cells.boundary, r.cells.volume, kRun);
    EXPECT_TRUE(v.valid) << (v.failures.empty() ? "" : v.failures.front().what);
  }
  static Revision edited(const Revision& original, const std::string& parameter, double value) {
    return make_revision(
        original, apply(original.source, ModelEdit{{SetParameter{parameter, value}}}), {}, kRun);
  }

  /// tool2-c with the end of its base .004 edge lengths behind the wall's: a ledge.
  static ModelSource ledge() {
    const ModelEdit shorter{{SetFeatureParameter{"base", "dx", 119.98}}};
    return apply(test::case_model("tool2-c"), shorter);
  }

  const Revision original_ = make_revision(Revision::none(), ledge(), {.nodes = 3000}, kRun);
};

TEST_F(RevisionByTetGen, IsWhatALedgeMuchLowerThanAnEdgeEndsIn) {
  EXPECT_EQ(original_.report.strategy, MeshStrategy::TetGen);
  expect_valid(original_);
  EXPECT_EQ(original_.report.counts.nodes_new, original_.report.counts.nodes);
  EXPECT_GT(original_.report.quality.volume_length_mean, 0.7);
}

TEST_F(RevisionByTetGen, CanBeEditedLikeAnyOther) {
  expect_valid(edited(original_, "pipe_x", 5));
  // Without the ledge there is nothing left that the engine could not do.
  const Revision flush = make_revision(original_, test::case_model("tool2-c"), {}, kRun);
  expect_valid(flush);
  EXPECT_LT(flush.report.strategy, MeshStrategy::TetGen);
}

TEST_F(RevisionByTetGen, LeavesItsShareToTheTetsThatAnEditKeeps) {
  EXPECT_EQ(original_.report.last_resort_share, 1);
  const Revision same = make_revision(original_, original_.source, {}, kRun);
  EXPECT_EQ(same.report.strategy, MeshStrategy::Unchanged);
  EXPECT_EQ(same.report.last_resort_share, 1);

  const Revision flush = make_revision(original_, test::case_model("tool2-c"), {}, kRun);
  const Counts& counts = flush.report.counts;
  EXPECT_GE(flush.report.last_resort_share, 1.0 * counts.tets_kept / counts.tets);
  EXPECT_LT(flush.report.last_resort_share, 1);
  const Revision after = make_revision(flush, flush.source, {}, kRun);
  EXPECT_DOUBLE_EQ(after.report.last_resort_share, flush.report.last_resort_share);
  const Revision regular =
      make_revision(Revision::none(), test::case_model("tool2-c"), {.nodes = 2000}, kRun);
  EXPECT_EQ(regular.report.last_resort_share, 0);
}

TEST_F(RevisionByTetGen, SurvivesItsBytes) {
  const Revision restored = test::stored_and_loaded(original_);
  EXPECT_EQ(restored.output.mesh.tets, original_.output.mesh.tets);
  EXPECT_EQ(restored.report.strategy, MeshStrategy::TetGen);
}

}  // namespace
}  // namespace remeshd
