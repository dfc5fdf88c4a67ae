// First meshes and edits under a size field.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/circle_edges.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

MeshOptions graded(std::uint32_t nodes) {
  MeshOptions options{.nodes = nodes};
  options.sizing.even = false;
  return options;
}

/// Of an edit that keeps its base's density.
MeshOptions inherited() {
  MeshOptions options = graded(0);
  options.nodes.reset();
  return options;
}

bool has(const Revision& r, WarningCode code) {
  return std::ranges::find(r.report.warnings, code, &Warning::code) != r.report.warnings.end();
}

/// A plate with a hole and a pin, both much finer than the edge length of so few nodes.
ModelSource plate() {
  return test::model_of(
      {test::block("plate", 60, 60, 8),
       test::placed(test::cylinder("hole", 2, 10), -15, 0, -1, Nature::Subtractive),
       test::placed(test::cylinder("pin", 1.5, 6), 15, 0, 7)});
}

/// Nine pins that need more than 1,200 nodes for 12 edges round each.
ModelSource plate_with_pins() {
  ModelSource pins = test::model_of({test::block("plate", 60, 60, 8)});
  for (int k = 0; k < 9; ++k)
    pins.features.push_back(test::placed(test::cylinder("pin" + std::to_string(k), 1.5, 6),
                                         -20 + 20 * (k % 3), -20 + 20 * (k / 3), 7));
  return pins;
}

TEST(Sizing, CirclesGetTheirEdgesAndTheBudgetHolds) {
  const Revision r = make_revision(Revision::none(), plate(), graded(3000), kRun);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
  EXPECT_GE(test::fewest_edges_on_circles(r), 12);
  EXPECT_NEAR(r.report.counts.nodes, 3000, 150);
  EXPECT_GE(r.report.quality.dihedral_min, 20);
  EXPECT_GE(r.report.quality.volume_length_mean, 0.78);
}

TEST(Sizing, TheBudgetHoldsWhereTheRulesJustDo) {
  // The search swung between weakened rules and coarser ones, and took its last start: 1,567.
  std::vector<FeatureSource> features{test::block("plate", 30, 30, 3)};
  int pin = 0;
  for (const double x : {-10.0, 0.0})
    for (const double y : {-10.0, 0.0, 10.0})
      features.push_back(
          test::placed(test::cylinder("pin" + std::to_string(pin++), 1.5, 3), x, y, 2.25));
  const Revision r = make_revision(Revision::none(), test::model_of(features), graded(1470), kRun);
  EXPECT_NEAR(r.report.counts.nodes, 1470, 0.03 * 1470);
}

TEST(Sizing, WithoutItTheSameCirclesAreCoarse) {
  const Revision r = make_revision(Revision::none(), plate(), {.nodes = 3000}, kRun);
  EXPECT_LT(test::fewest_edges_on_circles(r), 8);
}

TEST(Sizing, AModelWithoutRoundFacesIsMeshedEvenly) {
  const ModelSource source = test::case_model("simple-a");
  const Revision even = make_revision(Revision::none(), source, {.nodes = 1500}, kRun);
  const Revision r = make_revision(Revision::none(), source, graded(1500), kRun);
  EXPECT_EQ(r.output.mesh.nodes, even.output.mesh.nodes);
  EXPECT_EQ(r.output.mesh.tets, even.output.mesh.tets);
}

TEST(Sizing, AnEditKeepsTheBaseSizeAndWhatIsFarFromIt) {
  const Revision base = make_revision(Revision::none(), plate(), graded(3000), kRun);
  ModelSource edited = plate();
  edited.features[1].parameters["radius"] = 2.5;
  const Revision r = make_revision(base, edited, inherited(), kRun);
  EXPECT_EQ(r.edge_length, base.edge_length);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
  EXPECT_GE(test::fewest_edges_on_circles(r), 12);
  EXPECT_GE(r.report.counts.nodes_kept, 0.5 * base.report.counts.nodes);
  EXPECT_GE(r.report.quality.dihedral_min, 20);
}

TEST(Sizing, TheWorstTetIsOptimisedWhereManyAreBelowTheThreshold) {
  // Where the pipe comes to overlap the stiffener's toe 22 tets are left below the threshold: the
  // worst had 19.8 degrees.
  MeshOptions options = graded(3000);
  options.seed = 5;
  const Revision base = make_revision(Revision::none(), test::case_model("tool2-c"), options, kRun);
  options.nodes.reset();
  const Revision r = make_revision(base, test::case_model("tool2-d"), options, kRun);
  EXPECT_GE(r.report.quality.dihedral_min, 20);
}

TEST(Sizing, AGrooveInARimStaysOpen) {
  // Nodes of both flanges lie on one cylinder: tets between them are outside, wherever their
  // centroids are.
  const ModelSource wheel = test::model_of(
      {test::cylinder("disc", 24, 10), test::placed(test::cylinder("rim", 30, 3.5), 0, 0, 0),
       test::placed(test::cylinder("rim2", 30, 3.5), 0, 0, 6.5)});
  const Revision r = make_revision(Revision::none(), wheel, graded(4000), kRun);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
  EXPECT_TRUE(r.report.attempts.empty());
  EXPECT_GE(r.report.quality.dihedral_min, 20);
}

TEST(Sizing, AFaceThatIsTiltedALittleIsMeshedAsBefore) {
  // A turned flange whose upper side becomes a cone that rises by .1 over 15: it had 45 times as
  // many nodes.
  const auto flange = [](double rise) {
    using test::point;
    return test::model_of(
        {test::feature("flange", "revolution",
                       {point(0.0, 0.0), point(28.0, 0.0), point(28.0, 7.5),
                        point(12.0, 7.5 - rise), point(12.0, 18.0), point(0.0, 18.0)},
                       {{"angle", 360.0}})});
  };
  const Revision base = make_revision(Revision::none(), flange(0), graded(2000), kRun);
  const Revision edited = make_revision(base, flange(0.1), inherited(), kRun);
  EXPECT_NEAR(edited.report.counts.nodes, base.report.counts.nodes, 50);
  const Revision first = make_revision(Revision::none(), flange(0.1), graded(2000), kRun);
  EXPECT_NEAR(first.report.counts.nodes, 2000, 100);
}

TEST(Sizing, AWallOfOneAndAHalfEdgeLengthsHasNodesInItsMiddle) {
  // All of them went to its sides, with flat tets between: a mean of .68 and .72.
  for (const auto& [thickness, mean] : {std::pair{2.25, 0.73}, std::pair{2.5, 0.78}}) {
    MeshOptions options{.size = 1.5};
    options.sizing.even = false;
    const Revision r =
        make_revision(Revision::none(), test::one_feature(test::block("plate", 40, 40, thickness)),
                      options, kRun);
    EXPECT_GE(r.report.quality.volume_length_mean, mean) << thickness;
    EXPECT_GE(r.report.quality.dihedral_min, 24.5) << thickness;
  }
}

TEST(Sizing, AFewFaultsAreMendedByNodesAndNotFilled) {
  // Where a round of insertion left as many faults as before, two, TetGen filled their place.
  for (const auto& [major, minor] : {std::pair{10.0, 6.0}, std::pair{6.0, 5.0}}) {
    const Revision ring = make_revision(
        Revision::none(),
        test::model_of(
            {test::feature("ring", "torus", {{"major_radius", major}, {"minor_radius", minor}})}),
        graded(5000), kRun);
    EXPECT_EQ(ring.report.last_resort_share, 0) << major;
    EXPECT_GE(ring.report.quality.dihedral_min, 24) << major;
  }
}

TEST(Sizing, RulesThatNeedMoreNodesAreWeakenedAndTold) {
  const ModelSource pins = plate_with_pins();
  const Revision r = make_revision(Revision::none(), pins, graded(1200), kRun);
  EXPECT_GT(r.rules_weakening, 1.05);
  EXPECT_GE(test::fewest_edges_on_circles(r), 6);
  const auto told =
      std::ranges::find(r.report.warnings, WarningCode::DetailNotResolved, &Warning::code);
  ASSERT_NE(told, r.report.warnings.end());
  EXPECT_NE(told->message.find("nodes would do"), std::string::npos);
  // The count that is told makes them whole.
  const std::size_t at = told->message.find("; ") + 2;
  const auto enough = static_cast<std::uint32_t>(std::stoi(told->message.substr(at)));
  const Revision whole = make_revision(Revision::none(), pins, graded(enough * 21 / 20), kRun);
  EXPECT_EQ(whole.rules_weakening, 1);
  EXPECT_GE(test::fewest_edges_on_circles(whole), 12);
}

TEST(Sizing, WeakenedRulesHoldOnInEditsAndAreToldUntilAnEditHasItsOwn) {
  ModelSource pins = plate_with_pins();
  const Revision first = make_revision(Revision::none(), pins, graded(1200), kRun);
  MeshOptions options = inherited();
  pins.features[1].parameters["height"] = 7.0;
  const Revision edited = make_revision(first, pins, options, kRun);
  EXPECT_EQ(edited.rules_weakening, first.rules_weakening);
  EXPECT_TRUE(has(edited, WarningCode::DetailNotResolved));
  EXPECT_LT(test::fewest_edges_on_circles(edited), 12);
  options.sizing.min_size = 0.3;
  const Revision full = make_revision(edited, pins, options, kRun);
  EXPECT_EQ(full.rules_weakening, 1);
  EXPECT_FALSE(has(full, WarningCode::DetailNotResolved));
  EXPECT_GE(test::fewest_edges_on_circles(full), 12);
}

TEST(Sizing, RulesAreNotWeakenedForSizesThatNeedTheNodes) {
  // There is no circle: "whose circles get 7 edges" was said all the same.
  ModelSource block = test::model_of({test::block("b", 40, 40, 40)});
  block.sizes = {{"top", "b.top", 1.5}};
  const Revision r = make_revision(Revision::none(), block, graded(200), kRun);
  EXPECT_EQ(r.rules_weakening, 1);
  EXPECT_FALSE(has(r, WarningCode::DetailNotResolved));
  EXPECT_TRUE(has(r, WarningCode::NodesFarFromTarget));
}

TEST(Sizing, RulesAreNotWeakenedWhereTheModelsSizesAskForAsMuch) {
  // The hole's circles ask for 12 edges, its wall for 25: weaker rules save no node.
  ModelSource source = plate();
  source.features.pop_back();
  source.sizes = {{"wall", "hole.wall", 0.5}};
  MeshOptions options = graded(300);
  options.sizing.layers = 0;
  options.sizing.min_size = 0.2;
  const Revision r = make_revision(Revision::none(), source, options, kRun);
  EXPECT_EQ(r.rules_weakening, 1);
  EXPECT_FALSE(has(r, WarningCode::DetailNotResolved));
  EXPECT_TRUE(has(r, WarningCode::NodesFarFromTarget));
}

TEST(Sizing, LayersThatTheLeastSizeLeavesOutAreTold) {
  ModelSource pocket =
      test::model_of({test::block("b", 30, 30, 8), test::placed(test::block("pocket", 10, 10, 8), 0,
                                                                0, 0.35, Nature::Subtractive)});
  MeshOptions options = inherited();
  options.size = 4;
  options.sizing.layers = 3;
  const Revision r = make_revision(Revision::none(), pocket, options, kRun);
  EXPECT_TRUE(has(r, WarningCode::DetailNotResolved));
}

TEST(Sizing, ASizeBesideTheModelIsTold) {
  ModelSource source = plate();
  source.sizes = {{"near", BallSource{0.0, 0.0, 4.0, 3.0}, 2.0}};
  EXPECT_FALSE(
      has(make_revision(Revision::none(), source, graded(1500), kRun), WarningCode::GroupEmptied));
  source.sizes.push_back({"far", BallSource{500.0, 0.0, 0.0, 5.0}, 1.0});
  EXPECT_TRUE(
      has(make_revision(Revision::none(), source, graded(1500), kRun), WarningCode::GroupEmptied));
}

TEST(Sizing, ANumberOfNodesMeansTheSameInAnEditAsInAFirstMesh) {
  const Revision first = make_revision(Revision::none(), plate(), graded(3000), kRun);
  ModelSource edited = plate();
  edited.features.push_back(test::placed(test::block("boss", 20, 20, 10), 0, 15, 8));
  // The number that the base was made for: nothing gets denser.
  const Revision same = make_revision(first, edited, graded(3000), kRun);
  const Revision plain = make_revision(first, edited, inherited(), kRun);
  EXPECT_TRUE(same.dense_places.empty());
  EXPECT_EQ(same.output.mesh.nodes, plain.output.mesh.nodes);
  const Revision denser = make_revision(first, edited, graded(6000), kRun);
  EXPECT_FALSE(denser.dense_places.empty());
  EXPECT_EQ(denser.edge_length, first.edge_length);
  EXPECT_GT(denser.report.counts.nodes, plain.report.counts.nodes);
  EXPECT_TRUE(has(denser, WarningCode::NodesFarFromTarget));
}

TEST(Sizing, EdgesLongerThanItsBasesAreNoEditsToMakeAndThatIsTold) {
  const Revision first = make_revision(Revision::none(), plate(), graded(3000), kRun);
  ModelSource edited = plate();
  edited.features[2].parameters["height"] = 9.0;
  MeshOptions coarser = inherited();
  coarser.size = 2 * first.edge_length;
  const Revision r = make_revision(first, edited, coarser, kRun);
  EXPECT_EQ(r.edge_length, first.edge_length);
  EXPECT_TRUE(has(r, WarningCode::NodesFarFromTarget));
  MeshOptions even = coarser;
  even.sizing.even = true;
  EXPECT_TRUE(has(make_revision(first, edited, even, kRun), WarningCode::NodesFarFromTarget));
  coarser.size = first.edge_length;
  EXPECT_FALSE(has(make_revision(first, edited, coarser, kRun), WarningCode::NodesFarFromTarget));
}

TEST(Sizing, WhatTheLeastSizeLeavesOutIsToldByFeature) {
  MeshOptions options = graded(3000);
  options.sizing.min_size = 1.5;
  const Revision r = make_revision(Revision::none(), plate(), options, kRun);
  const auto told =
      std::ranges::find(r.report.warnings, WarningCode::DetailNotResolved, &Warning::code);
  ASSERT_NE(told, r.report.warnings.end());
  EXPECT_EQ(told->features, (std::vector<std::string>{"pin", "hole"})) << "the smallest first";
  ASSERT_TRUE(told->point);
  EXPECT_NEAR(std::hypot(told->point->x - 15, told->point->y), 1.5, 1e-6) << "where it is";
}

}  // namespace
}  // namespace remeshd
