#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random.h"
#include "engine/remesh/remesh.h"
#include "engine/verify/verify.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

struct Knob {
  const char* parameter;
  double lo, hi;
};
struct Chain {
  const char* model;
  std::vector<Knob> knobs;
};

class ChainOfEdits : public testing::TestWithParam<Chain> {};

/// How the mesh at the end of a chain stands to one that is made of its model at once.
struct Ending {
  double lost;   ///< mean volume-length
  double nodes;  ///< ratio
};

Ending end_of_chain(const Chain& chain, std::uint64_t seed) {
  ModelSource source = test::case_model(chain.model);
  Random random(seed);
  Revision r = make_revision(Revision::none(), source, {.nodes = 2000}, kRun);
  for (int k = 0; k < 100; ++k) {
    const Knob& knob = chain.knobs[random.below(chain.knobs.size())];
    test::parameter(source, knob.parameter) = random.uniform(knob.lo, knob.hi);
    r = make_revision(r, source, {}, kRun);
  }
  EXPECT_TRUE(verify(r.output.mesh, r.supports(), r.cells.boundary, r.cells.volume, kRun).valid);
  const Revision fresh = make_revision(Revision::none(), source, {.size = r.edge_length}, kRun);
  return {fresh.report.quality.volume_length_mean - r.report.quality.volume_length_mean,
          static_cast<double>(r.report.counts.nodes) / fresh.report.counts.nodes};
}

/// What a single chain ends with depends on roundings: its nodes spread by .035 of a fresh mesh's,
/// its mean measure by .004. What edits wear off shows in the mean of some.
TEST_P(ChainOfEdits, IsAsGoodAsFreshAfterAHundred) {
  constexpr int kChains = 3;
  Ending mean{0, 0};
  for (std::uint64_t seed = 7; seed < 7 + kChains; ++seed) {
    const Ending ending = end_of_chain(GetParam(), seed);
    mean.lost += ending.lost / kChains;
    mean.nodes += ending.nodes / kChains;
  }
  EXPECT_LE(mean.lost, 0.01);
  EXPECT_NEAR(mean.nodes, 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Models, ChainOfEdits,
    testing::Values(Chain{"simple-a", {{"top_x", -20, 20}}},
                    Chain{"tool1-a",
                          {{"pin_radius", 3, 5}, {"hole_circle", 33, 39}, {"hole_turn", 0, 12}}},
                    Chain{"tool2-c", {{"pipe_x", 5, 28}}}),
    [](const auto& chain) {
      std::string name = chain.param.model;
      std::erase(name, '-');
      return name;
    });

TEST(ToAndFro, TheNumberOfNodesStaysWhatTheModelNeeds) {
  // Three features turn round the axis: their nodes crowd where they come to stand and leave voids
  // where they were.
  const ModelSource there = test::case_model("tool1-a");
  const ModelSource back = apply(there, test::case_edit("tool1-ac"));
  Revision r = make_revision(Revision::none(), there, {.nodes = 4000, .iterations = 5}, kRun);
  for (int k = 0; k < 8; ++k) {
    r = make_revision(r, k % 2 == 0 ? back : there, {.iterations = 5}, kRun);
    EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
    EXPECT_NEAR(r.report.counts.nodes, 4000, 100) << "edit " << k;
  }
}

TEST(ToAndFro, ABoundaryThatIsBuriedAndLaidBareAgainWearsNothingOut) {
  // The block grows past its own sides and bosses move, then all goes back.
  const ModelSource there = test::case_model("tool3-a");
  const ModelSource back = apply(there, test::case_edit("tool3-ab"));
  const Revision first =
      make_revision(Revision::none(), there, {.nodes = 4000, .iterations = 10}, kRun);
  Revision r = first;
  for (int k = 0; k < 8; ++k) {
    r = make_revision(r, k % 2 == 0 ? back : there, {.iterations = 10}, kRun);
    EXPECT_EQ(r.report.strategy, MeshStrategy::Local) << "edit " << k;
  }
  EXPECT_GT(r.report.quality.volume_length_mean, first.report.quality.volume_length_mean - 0.004);
}

TEST(AutomaticIterations, AreNotEndedByTheNodesThatFillVoids) {
  const ModelSource there = test::case_model("tool3-a");
  const ModelSource edited = apply(there, test::case_edit("tool3-ab"));
  const Revision base = make_revision(Revision::none(), there, {.nodes = 4000}, kRun);
  const Revision r = make_revision(base, edited, {}, kRun);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
  const Revision regular =
      make_revision(Revision::none(), edited, {.nodes = r.report.counts.nodes}, kRun);
  EXPECT_GT(r.report.quality.volume_length_mean, regular.report.quality.volume_length_mean - 0.01);
}

/// A remesh of a mesh that was made in one iteration from random nodes, in a chain that is said to
/// have begun with a mean volume-length of .87.
Revision remesh_of_a_poor_mesh(const MeshOptions& options) {
  Revision base =
      make_revision(Revision::none(), test::case_model("simple-a"),
                    {.nodes = 2500, .iterations = 1, .start = MeshOptions::Start::Random}, kRun);
  base.reference.volume_length_mean = 0.87;
  const ModelSource edited = apply(base.source, test::case_edit("simple-ab"));
  return make_revision(base, edited, options, kRun);
}

TEST(WornMesh, IsMadeAnewAndTheReportSaysSo) {
  const Revision anew = remesh_of_a_poor_mesh({});
  EXPECT_EQ(anew.report.strategy, MeshStrategy::Renewed);
  EXPECT_EQ(anew.report.counts.nodes_kept, 0U);
  EXPECT_GT(anew.report.quality.volume_length_mean, 0.85);
  EXPECT_EQ(anew.reference.volume_length_mean, anew.report.quality.volume_length_mean);
  ASSERT_FALSE(anew.report.warnings.empty());
  EXPECT_EQ(anew.report.warnings.back().code, WarningCode::Renewed);
}

TEST(WornMesh, StaysWhereARegularOneIsNoBetter) {
  const Revision remesh =
      remesh_of_a_poor_mesh({.iterations = 1, .start = MeshOptions::Start::Random});
  EXPECT_EQ(remesh.report.strategy, MeshStrategy::Local);
  EXPECT_GT(remesh.report.counts.nodes_kept, 0U);
  EXPECT_EQ(remesh.reference.volume_length_mean, remesh.report.quality.volume_length_mean);
}

}  // namespace
}  // namespace remeshd
