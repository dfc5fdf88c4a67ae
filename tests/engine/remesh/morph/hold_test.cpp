#include "engine/remesh/morph/hold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/remesh/morph/horizon.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

bool has_ended(const Revision& r) {
  return std::ranges::any_of(r.report.warnings, [](const Warning& warning) {
    return warning.code == WarningCode::HoldEnded;
  });
}

class Hold : public testing::Test {
 protected:
  /// The pipe elsewhere, by edge lengths.
  [[nodiscard]] ModelSource moved(double by) const {
    return apply(source_, {{SetParameter{"pipe_x", 15 + by * l_}}});
  }
  [[nodiscard]] static Revision edit(const Revision& parent, const ModelSource& source) {
    MeshOptions options = parent.options;
    options.nodes.reset();
    options.size.reset();
    return make_revision(parent, source, options, kRun);
  }
  const ModelSource source_ = test::case_model("tool2-a");
  const Revision base_ =
      make_revision(Revision::none(), source_, {.nodes = 1500, .order = 2, .hold = 1}, kRun);
  const double l_ = base_.edge_length;
};

TEST_F(Hold, MeshesAFirstTimeAsEver) {
  const Revision plain =
      make_revision(Revision::none(), source_, {.nodes = 1500, .order = 2}, kRun);
  EXPECT_EQ(plain.output.mesh.nodes, base_.output.mesh.nodes);
  EXPECT_EQ(plain.output.mesh.tets, base_.output.mesh.tets);
}

TEST_F(Hold, KeepsTheConnectivityUpToItsLength) {
  for (const double by : {1e-6, 0.005, 0.3, -0.7, 0.99}) {
    SCOPED_TRACE(by);
    const Revision r = edit(base_, moved(by));
    EXPECT_EQ(r.report.strategy, MeshStrategy::Morphed);
    EXPECT_EQ(r.output.mesh.tets, base_.output.mesh.tets);
    EXPECT_EQ(r.output.node_ids, base_.output.node_ids);
    EXPECT_EQ(r.output.mids.edges, base_.output.mids.edges);
    EXPECT_FALSE(has_ended(r));
    EXPECT_GE(r.report.quality.dihedral_min, 10);
    EXPECT_TRUE(verify(r.output.mesh, r.supports(), r.cells.boundary, r.cells.volume, kRun).valid);
  }
}

TEST_F(Hold, EndsInOneStepOrManyAtTheSamePlace) {
  const Revision at_once = edit(base_, moved(0.9));
  Revision step = base_;
  for (const double by : {0.1, 0.4, -0.2, 0.3, 0.7, 0.9}) step = edit(step, moved(by));
  ASSERT_EQ(step.report.strategy, MeshStrategy::Morphed);
  for (std::size_t n = 0; n < step.output.mesh.nodes.size(); ++n)
    EXPECT_NEAR(distance(step.output.mesh.nodes[n], at_once.output.mesh.nodes[n]), 0, 1e-9 * l_);
}

TEST_F(Hold, SaysWhenItEnds) {
  const Revision further = edit(edit(base_, moved(0.8)), moved(1.2));
  EXPECT_NE(further.report.strategy, MeshStrategy::Morphed);
  EXPECT_TRUE(has_ended(further));
  ModelSource without = source_;
  without.features.pop_back();
  const Revision other = edit(base_, without);
  EXPECT_NE(other.report.strategy, MeshStrategy::Morphed);
  EXPECT_TRUE(has_ended(other));
  // From there it counts anew.
  const Revision again = edit(further, moved(1.9));
  EXPECT_EQ(again.report.strategy, MeshStrategy::Morphed);
}

TEST_F(Hold, GoesOnFromAStoredRevision) {
  const Revision half = edit(base_, moved(0.5));
  const Revision loaded = test::stored_and_loaded(half);
  EXPECT_EQ(loaded.options.hold, 1);
  EXPECT_EQ(edit(loaded, moved(0.9)).output.mesh.nodes, edit(half, moved(0.9)).output.mesh.nodes);
}

TEST_F(Hold, FollowsTheRimOfAGroup) {
  ModelSource stack =
      test::model_of({test::block("low", 20, 20, 10), test::block("pad", 8, 8, 10)});
  stack.groups.push_back({"load", "pad.top"});
  const Revision base = make_revision(Revision::none(), stack, {.nodes = 400, .hold = 1}, kRun);
  ModelSource wider = stack;
  wider.features[1].parameters["dx"] = 8 + base.edge_length;
  const Revision r = edit(base, wider);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Morphed);
  const auto load = std::ranges::find(r.report.figures, "load", &GroupFigures::group);
  ASSERT_NE(load, r.report.figures.end());
  EXPECT_NEAR(load->mesh_area, 8 * (8 + base.edge_length), 1e-9);
  EXPECT_GT(connectivity_horizon(base, "pad.dx", 1, kRun).upper, 8 + base.edge_length);
}

TEST_F(Hold, FollowsFacesOfAFeatureThatGetsOneMore) {
  // A cone's lower end is a point or a disc, inside of the block either way.
  const auto source = [](double radius) {
    return test::model_of(
        {test::block("block", 20, 20, 10),
         test::placed(
             test::feature("tip", "cone",
                           {{"radius_bottom", radius}, {"radius_top", 4.0}, {"height", 10.0}}),
             0, 0, 5)});
  };
  const Revision base =
      make_revision(Revision::none(), source(0), {.nodes = 1500, .hold = 1}, kRun);
  const Revision r = edit(base, source(0.1));
  EXPECT_EQ(r.report.strategy, MeshStrategy::Morphed);
  EXPECT_FALSE(has_ended(r));
}

TEST_F(Hold, IsLeftForOtherSizes) {
  ModelSource sized = source_;
  sized.sizes.push_back({"spot", BallSource{0.0, 0.0, 0.0, 8.0}, 0.3 * l_});
  MeshOptions options = base_.options;
  options.nodes.reset();
  options.sizing.even = false;
  const Revision base = make_revision(Revision::none(), source_,
                                      {.nodes = 1500, .hold = 1, .sizing = options.sizing}, kRun);
  const Revision spot = make_revision(base, sized, options, kRun);
  EXPECT_NE(spot.report.strategy, MeshStrategy::Morphed);
  EXPECT_TRUE(has_ended(spot));
  options.sizing.edges_per_circle = 24;
  const Revision finer = make_revision(base, source_, options, kRun);
  EXPECT_NE(finer.report.strategy, MeshStrategy::Morphed);
  EXPECT_TRUE(has_ended(finer));
}

TEST_F(Hold, SaysSoWhenOtherOptionsEndIt) {
  MeshOptions options = base_.options;
  options.nodes.reset();
  MeshOptions finer = options, thorough = options;
  finer.size = 0.5 * l_;
  thorough.threshold = 0.5;
  for (const MeshOptions& asked : {finer, thorough})
    EXPECT_TRUE(has_ended(make_revision(base_, moved(0.3), asked, kRun)));
}

TEST_F(Hold, HasAHorizonThatEditsKeepTo) {
  const Horizon horizon = connectivity_horizon(base_, "pipe_x", 1, kRun);
  EXPECT_EQ(horizon.value, 15);
  EXPECT_NEAR(horizon.upper, 15 + l_, 0.02 * l_);
  EXPECT_NEAR(horizon.lower, 15 - l_, 0.02 * l_);
  EXPECT_FALSE(horizon.upper_reason.empty());
  const ModelSource at_end = apply(source_, {{SetParameter{"pipe_x", horizon.upper}}});
  EXPECT_EQ(edit(base_, at_end).report.strategy, MeshStrategy::Morphed);
}

TEST_F(Hold, HasAHorizonWithoutIt) {
  const Horizon horizon = connectivity_horizon(base_, "pipe_x", 0, kRun);
  EXPECT_LT(horizon.upper, 15 + 0.0101 * l_);
  EXPECT_GT(horizon.upper, 15 + 0.005 * l_);
}

TEST_F(Hold, HasAHorizonWithoutItThatIsAsExactWhereEdgesAreShorterThanTheBaseSize) {
  MeshOptions sized{.size = 8};
  sized.sizing = {.even = false, .edges_per_circle = 36};
  const Revision base = make_revision(Revision::none(), source_, sized, kRun);
  const double least = base.sizes->least();
  ASSERT_LT(least, 0.4 * base.edge_length);
  const Horizon horizon = connectivity_horizon(base, "pipe_x", 0, kRun);
  EXPECT_LT(horizon.upper, 15 + 0.0101 * least);
  EXPECT_GT(horizon.upper, 15 + 0.0098 * least);
}

TEST_F(Hold, HasAHorizonWithinTheParametersBounds) {
  ModelSource bounded = source_;
  bounded.parameters.front().upper = 15.5;
  const Revision base = make_revision(Revision::none(), bounded, {.nodes = 800, .hold = 1}, kRun);
  const Horizon horizon = connectivity_horizon(base, "pipe_x", 1, kRun);
  EXPECT_EQ(horizon.upper, 15.5);
  EXPECT_NE(horizon.upper_reason.find("bound"), std::string::npos);
}

}  // namespace
}  // namespace remeshd
