#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random.h"
#include "engine/remesh/remesh.h"
#include "engine/verify/verify.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

struct Knob {
  const char* parameter;
  double lo, hi;
};
struct Chain {
  const char* model;
  std::vector<Knob> knobs;
};

class ChainOfEdits : public testing::TestWithParam<Chain> {};

TEST_P(ChainOfEdits, IsAsGoodAsFreshAfterAHundred) {
  ModelSource source = test::case_model(GetParam().model);
  Random random(7);
  Revision r = make_revision(nullptr, source, {.nodes = 2000}, kRun);
  for (int k = 0; k < 100; ++k) {
    const Knob& knob = GetParam().knobs[random.below(GetParam().knobs.size())];
    source.parameters[knob.parameter] = random.uniform(knob.lo, knob.hi);
    r = make_revision(&r, source, {}, kRun);
  }
  const Revision fresh = make_revision(nullptr, source, {.size = r.edge_length}, kRun);
  EXPECT_GE(r.report.quality.volume_length_mean, fresh.report.quality.volume_length_mean - 0.01);
  EXPECT_NEAR(r.report.counts.nodes, fresh.report.counts.nodes, 0.12 * fresh.report.counts.nodes);
  EXPECT_TRUE(verify(r.delivery.mesh, r.supports(), r.cells.boundary, r.cells.volume, kRun).valid);
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

/// A remesh of a mesh that was made in one iteration from random nodes, in a chain that is said to
/// have begun with a mean volume-length of .87.
Revision remesh_of_a_poor_mesh(const MeshOptions& options) {
  Revision base =
      make_revision(nullptr, test::case_model("simple-a"),
                    {.nodes = 2500, .iterations = 1, .start = MeshOptions::Start::Random}, kRun);
  base.reference.volume_length_mean = 0.87;
  const ModelSource edited = apply(base.source, test::case_edit("simple-ab"));
  return make_revision(&base, edited, options, kRun);
}

TEST(WornMesh, IsMadeAnewAndTheReportSaysSo) {
  const Revision anew = remesh_of_a_poor_mesh({});
  EXPECT_EQ(anew.report.way, Way::Rebased);
  EXPECT_EQ(anew.report.counts.nodes_kept, 0U);
  EXPECT_GT(anew.report.quality.volume_length_mean, 0.85);
  EXPECT_EQ(anew.reference.volume_length_mean, anew.report.quality.volume_length_mean);
  ASSERT_FALSE(anew.report.warnings.empty());
  EXPECT_NE(anew.report.warnings.back().find("worn"), std::string::npos);
}

TEST(WornMesh, StaysWhereARegularOneIsNoBetter) {
  const Revision remesh =
      remesh_of_a_poor_mesh({.iterations = 1, .start = MeshOptions::Start::Random});
  EXPECT_EQ(remesh.report.way, Way::Local);
  EXPECT_GT(remesh.report.counts.nodes_kept, 0U);
  EXPECT_EQ(remesh.reference.volume_length_mean, remesh.report.quality.volume_length_mean);
}

}  // namespace
}  // namespace remeshd
