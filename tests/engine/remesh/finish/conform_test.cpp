// Nodes inserted until the boundary is all there, as whole meshes show it.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

TEST(Conforming, OfAPartThatNothingIsInGoesOnInALargerOne) {
  // A corner of the block stands out of the ring beside the post, by so little that no sample finds
  // it: no node is freed.
  FeatureSource ring =
      test::feature("ring", "revolution",
                    {test::point(0.69, 0.0), test::point(3.1, 0.0), test::point(3.1, 1.1),
                     test::point(1.5, 1.1), test::point(1.5, 2.8), test::point(0.69, 2.8)},
                    {{"angle", 360.0}});
  const FeatureSource post = test::placed(test::cylinder("post", 0.38, 1.5), -0.87, -2.1, 0.69);
  FeatureSource block =
      test::turned(test::placed(test::block("block", 0.71, 0.45, 0.22), -0.87, -2.1, 0.95),
                   {-0.0517814985816592, -0.13907971379375925, 0.9889264429752517},
                   {-0.34505289105670045, -0.9267761390913646, -0.1484065038477639});
  block.reference = ReferenceKind::Centre;
  const ModelSource model = test::model_of({ring, post});
  const Revision base = make_revision(Revision::none(), model, {.nodes = 300, .seed = 53}, kRun);
  const Revision edited =
      make_revision(base, apply(model, ModelEdit{{AddFeature{block, ""}}}), {.seed = 53}, kRun);
  EXPECT_FALSE(edited.output.mesh.tets.empty());
}

/// Two blocks whose upper sides are `step` apart: edges of the step run side by side.
ModelSource blocks_next_to_flush(double step) {
  return test::model_of(
      {test::block("plate", 40, 40, 10),
       test::turned(test::placed(test::block("tongue", 30, 16, 10 - step), 25, 2, 0), {0, 0, 1},
                    {std::cos(0.035), std::sin(0.035), 0})});
}

const MeshOptions kSized{.nodes = 3000, .iterations = 10, .sizing = {.even = false}};

TEST(Conforming, OfAStepMuchLowerThanEdgesAreLongTakesNoLastResort) {
  for (const double step : {0.005, 0.02}) {
    const Report report =
        make_revision(Revision::none(), blocks_next_to_flush(step), kSized, kRun).report;
    EXPECT_EQ(report.strategy, MeshStrategy::Local) << step;
    EXPECT_EQ(report.last_resort_share, 0) << step;
  }
}

TEST(Conforming, OfABlockThatDriftsThroughTheHeightOfAnotherKeepsMostNodes) {
  Revision revision = make_revision(Revision::none(), blocks_next_to_flush(0.1), kSized, kRun);
  for (const double step : {0.02, 0.005, 0.0, -0.005}) {
    revision = make_revision(revision, blocks_next_to_flush(step), kSized, kRun);
    const Report& report = revision.report;
    EXPECT_EQ(report.strategy, MeshStrategy::Local) << step;
    EXPECT_LT(report.last_resort_share, 0.1) << step;
    EXPECT_GT(report.counts.nodes_kept, 0.6 * report.counts.nodes) << step;
  }
}

TEST(Conforming, OfAWedgeBetweenTwoPinsThatMeetTakesNoLastResort) {
  const auto pin = [](const char* id, double x) {
    return test::placed(test::cylinder(id, 1.5, 4), x, 0, 1.5);
  };
  for (const double overlap : {0.01, 0.03}) {
    const ModelSource model =
        test::model_of({test::placed(test::block("plate", 12, 8, 2), -6, -4, 0),
                        pin("left", -1.5 + overlap / 2), pin("right", 1.5 - overlap / 2)});
    const Report report = make_revision(Revision::none(), model, kSized, kRun).report;
    EXPECT_EQ(report.strategy, MeshStrategy::Local) << overlap;
    EXPECT_EQ(report.last_resort_share, 0) << overlap;
  }
}

TEST(Conforming, OfAWallBesideAHoleMuchThinnerThanEdgesAreLongTakesNoLastResort) {
  const double wall = 0.01;
  const ModelSource model = test::model_of(
      {test::block("plate", 12, 8, 4),
       test::placed(test::cylinder("hole", 1.5, 6), 4.5 - wall, 0, 0, Nature::Subtractive)});
  const Report report = make_revision(Revision::none(), model, kSized, kRun).report;
  EXPECT_EQ(report.strategy, MeshStrategy::Local);
  EXPECT_EQ(report.last_resort_share, 0);
}

TEST(Conforming, IsFollowedByTheCleanUp) {
  // So coarse that the boundary is not all there at first.
  int repaired = 0;
  for (const std::uint32_t nodes : {60U, 80U, 120U, 200U}) {
    const Report report =
        make_revision(Revision::none(), test::case_model("tool1-a"),
                      {.nodes = nodes, .iterations = 4, .start = MeshOptions::Start::Random}, kRun)
            .report;
    ASSERT_EQ(report.strategy, MeshStrategy::Local) << nodes;
    repaired += report.counts.nodes_inserted > 0 ? 1 : 0;
    EXPECT_LT(report.quality_before.volume_length_min, 0.1) << nodes << ": slivers before";
    EXPECT_GT(report.quality.volume_length_min, 0.2) << nodes;
  }
  EXPECT_GE(repaired, 2);
}

}  // namespace
}  // namespace remeshd
