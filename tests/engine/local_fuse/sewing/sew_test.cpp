#include "engine/local_fuse/sewing/sew.h"
#include "engine/local_fuse/local_fuse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "engine/base/random.h"
#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/large_models.h"
#include "tests/support/run.h"
#include "tests/support/same_boundary.h"

namespace remeshd {
namespace {

using test::kRun;

using test::block;
using test::cylinder;
using test::difference_of;
using test::placed;
using testing::ElementsAre;

/// A model with its cells, however they were made.
struct Made {
  FeatureModel model;
  CellularModel cells;

  explicit Made(const ModelSource& source)
      : model(evaluate(source)), cells(build_cells(model, kRun)) {}
  Made(const ModelSource& source, const Made& base)
      : model(evaluate(source)), cells(build_cells(model, base.model, base.cells, kRun)) {}
};

/// Whether what changed is less than all.
bool stitches(const ModelSource& source, const Made& base) {
  const FeatureModel model = evaluate(source);
  const Membership membership(model);
  return sew({model, membership}, {base.model, *base.cells.parts}, kRun).parts.has_value();
}

/// From the base, and from a build of its own, the same; returns it.
Made expect_same(const ModelSource& edited, const Made& base, const std::string& what) {
  Made from_base(edited, base);
  EXPECT_EQ(difference_of(Made(edited).cells, from_base.cells), "") << what;
  return from_base;
}

void expect_same_both_ways(const ModelSource& a, const ModelSource& b, const std::string& what) {
  expect_same(b, Made(a), what);
  expect_same(a, Made(b), what + " back");
}

TEST(StitchTest, EditsOfTheCasesGiveWhatABuildOfTheirOwnGives) {
  for (const test::EditCase& c : test::seven_cases())
    expect_same_both_ways(test::case_model(c.original), test::case_model(c.modified), c.edit);
  for (const std::string name : {"fig6", "fig8", "fig9", "fig10", "fig11"}) {
    const ModelSource a = test::case_model(name + "-a");
    expect_same_both_ways(a, apply(a, test::case_edit(name + "-ab")), name);
  }
}

TEST(StitchTest, OneOfManyFeaturesIsAllThatIsFused) {
  const ModelSource plate = test::plate_with_grid(50), row = test::row_of_blocks(30),
                    mixed = test::mixed_model(46);
  const auto check = [](const ModelSource& a, const ModelSource& b, const std::string& what) {
    EXPECT_TRUE(stitches(b, Made(a))) << what;
    expect_same_both_ways(a, b, what);
  };
  check(plate, test::with_moved(plate, "f21", 3, 2, 0), "hole moved");
  check(plate, test::with_moved(plate, "f20", 0, 0, -10), "pin sunk into the plate");
  check(plate, test::with_moved(plate, "f20", 5, 10, 0), "pin moved to two holes");
  check(plate, test::with_moved(plate, "f1", -6, 0, 0), "hole moved through the rim");
  check(plate, test::with_parameter(plate, "f20", "radius", 9), "pin up to holes");
  check(plate, test::with_parameter(plate, "f21", "height", 5), "hole no longer through");
  check(row, test::with_moved(row, "f10", 1, 0.3, 0.1), "block of a row moved");
  check(row, test::with_parameter(row, "f10", "dz", 30), "block of a row higher");
  check(row, test::with_parameter(row, "f10", "dy", 2), "block of a row narrower");
  check(mixed, test::with_parameter(mixed, "p1boss1", "radius", 9.5), "boss");
  check(mixed, test::with_parameter(mixed, "p1hole2", "radius", 4.5), "hole of a boss");
  check(mixed, test::with_parameter(mixed, "p1slot0", "length", 60), "slots that meet");
}

TEST(StitchTest, ARoundWallAllRoundAChangeStays) {
  const ModelSource disc = test::case_model("tool1-a");
  const Made base(disc);
  for (const std::string name : {"tool1-ab", "tool1-ac"}) {
    const ModelSource edited = apply(disc, test::case_edit(name));
    const Made made(edited, base);
    EXPECT_TRUE(stitches(edited, base)) << name;
    // The rim of the plate lies round pins and holes, but is not near them.
    int kept = 0;
    for (const kernel::BrepEdge& edge : base.cells.parts->brep.edges)
      if (edge.radius == 50)
        for (const kernel::BrepEdge& other : made.cells.parts->brep.edges)
          kept += other.points == edge.points ? 1 : 0;
    EXPECT_EQ(kept, 2) << name;
  }
}

TEST(StitchTest, WhatARoundWallGoesAroundIsNotNearIt) {
  const ModelSource disc = test::case_model("tool1-a");
  // Through the interface, for the CAD kernel, but not with all that stands on the disc.
  ModelSource edited = disc;
  ASSERT_EQ(edited.features[7].id, "hole1");
  edited.features[7].placement.origin = {48.0, 0.0, 0.0};
  EXPECT_TRUE(stitches(edited, Made(disc)));
  expect_same_both_ways(disc, edited, "hole through the rim");
}

TEST(StitchTest, FeaturesComeGoChangePlacesAndNatures) {
  const ModelSource plate = test::plate_with_grid(26);
  ModelSource removed = plate, turned = plate, reordered = plate, renamed = plate;
  std::erase_if(removed.features, [](const FeatureSource& f) { return f.id == "f7"; });
  turned.features[8].nature = Nature::Subtractive;
  std::swap(reordered.features[7], reordered.features[8]);
  std::rotate(reordered.features.begin() + 3, reordered.features.begin() + 4,
              reordered.features.end());
  renamed.features[5].id = "other";
  expect_same_both_ways(plate, removed, "removed");
  expect_same_both_ways(plate, turned, "another nature");
  expect_same_both_ways(plate, reordered, "another order");
  expect_same_both_ways(plate, renamed, "another name");
  expect_same(plate, Made(plate), "nothing");
}

TEST(StitchTest, AFaceThatIsCutInTwoAndJoinedAgain) {
  const ModelSource plate = test::plate_with_grid(17);
  ModelSource cut = plate;
  cut.features.push_back(placed(block("groove", 200, 3, 4), 0, 0, 8, Nature::Subtractive));
  EXPECT_TRUE(stitches(cut, Made(plate)));
  expect_same_both_ways(plate, cut, "a groove from rim to rim");
}

TEST(StitchTest, CavitiesAreNoPieces) {
  const ModelSource plate = test::plate_with_grid(17);
  ModelSource hollow = plate;
  hollow.features.push_back(placed(block("cavity", 4, 4, 4), 0, 0, 3, Nature::Subtractive));
  EXPECT_TRUE(stitches(hollow, Made(plate)));
  expect_same_both_ways(plate, hollow, "a cavity");
}

TEST(StitchTest, WhatIsWrongWithAModelIsToldAsEver) {
  const ModelSource row = test::row_of_blocks(12), plate = test::plate_with_grid(17);
  const auto same_error = [](const ModelSource& edited, const Made& base) {
    const ErrorInfo fresh = test::error_of([&] { Made{edited}; });
    const ErrorInfo from_base = test::error_of([&] { Made{edited, base}; });
    EXPECT_EQ(from_base.reason, fresh.reason);
    EXPECT_EQ(from_base.message, fresh.message);
    EXPECT_EQ(from_base.features, fresh.features);
    return fresh.reason;
  };
  EXPECT_EQ(same_error(test::with_moved(row, "f6", 0, 50, 0), Made(row)), "DISCONNECTED_MODEL");
  EXPECT_EQ(same_error(test::with_moved(plate, "f6", 0, 0, 20), Made(plate)), "DISCONNECTED_MODEL");
  ModelSource touching = plate;
  touching.features.push_back(placed(block("t1", 2, 2, 3), -1, -1, 10));
  touching.features.push_back(placed(block("t2", 2, 2, 3), 1, 1, 10));
  EXPECT_EQ(same_error(touching, Made(plate)), "NON_MANIFOLD_MODEL");
  ModelSource nothing = row;
  nothing.features.push_back(placed(block("all", 500, 500, 500), 0, 0, -250, Nature::Subtractive));
  EXPECT_EQ(same_error(nothing, Made(row)), "EMPTY_MODEL");
}

TEST(StitchTest, ChainsOfEditsStayExact) {
  const ModelSource start = test::mixed_model(31);
  ModelSource now = start;
  Random random(7);
  Made made(start);
  for (int k = 0; k < 60; ++k) {
    const FeatureSource& feature = start.features[1 + random.below(start.features.size() - 1)];
    if (feature.type == "block") continue;
    now =
        test::with_moved(now, feature.id, random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0);
    made = Made(now, made);
  }
  EXPECT_EQ(difference_of(Made(now).cells, made.cells), "");
  // And back: nothing of the way is left.
  EXPECT_EQ(difference_of(Made(start).cells, Made(start, made).cells), "");
  EXPECT_NEAR(Made(start, made).cells.volume, Made(start).cells.volume, 1e-8);
}

std::vector<std::string> in_words(const std::vector<GeometryAttempt>& attempts) {
  std::vector<std::string> all;
  for (const GeometryAttempt& attempt : attempts) {
    all.push_back(attempt.route + ": " + attempt.reason);
    EXPECT_GT(attempt.seconds, 0);
  }
  return all;
}

/// How parts came about, and why not otherwise.
std::vector<std::string> told(const ModelSource& edited, const ModelSource& base) {
  const FeatureModel model = evaluate(edited), before = evaluate(base);
  const Membership membership(model);
  const CellularModel cells = build_cells(before, kRun);
  const Sewn sewn = sew({model, membership}, {before, *cells.parts}, kRun);
  std::vector<std::string> all = in_words(sewn.given_up);
  // The cells that are made of it tell the same.
  const CellularModel from_base = build_cells(model, before, cells, kRun);
  EXPECT_EQ(in_words(from_base.geometry_attempts), all);
  EXPECT_EQ(from_base.parts->geometry, sewn.parts ? sewn.parts->geometry : "fused");
  all.emplace_back(sewn.parts ? sewn.parts->geometry : "none");
  return all;
}

TEST(StitchTest, TellsHowPartsCameAboutAndWhyNotOtherwise) {
  const auto pin_at = [](double x) {
    return test::model_of({block("plate", 40, 40, 5), placed(cylinder("pin", 3, 6), x, 0, 2)});
  };
  EXPECT_EQ(told(pin_at(0), pin_at(0)).back(), "kept");
  EXPECT_THAT(told(pin_at(0), pin_at(1)), ElementsAre("swept"));

  const auto pipe_with_fin_at = [](double x) {
    return test::model_of({cylinder("pipe", 4, 10), placed(block("fin", 10, 2, 3), x, 0, 4)});
  };
  EXPECT_THAT(told(pipe_with_fin_at(5), pipe_with_fin_at(6)),
              ElementsAre("swept: planar_arrangement: a round side meets or nearly meets a side of "
                          "another outline",
                          "crossed"));

  const auto ball_at = [](double x, bool boss_too) {
    const FeatureSource ball = test::feature("ball", "sphere", {{"radius", 6.0}});
    std::vector<FeatureSource> all{block("plate", 40, 40, 5), placed(ball, x, 0, 5)};
    if (boss_too) all.push_back(placed(block("boss", 4, 4, 4), -15, -15, 5));
    return test::model_of(all);
  };
  const std::string no_prism = "sweeps: a feature is neither a prism nor a cylinder";
  EXPECT_THAT(told(ball_at(0, true), ball_at(1, true)),
              ElementsAre("swept: " + no_prism, "crossed: " + no_prism, "fused in part"));
  EXPECT_THAT(told(ball_at(0, false), ball_at(1, false)),
              ElementsAre("swept: " + no_prism, "crossed: " + no_prism,
                          "fused in part: sew: every feature is near the change", "none"));
}

TEST(StitchTest, WhatARingGoesAroundIsNotNearIt) {
  const auto with_groove = [](double depth, double pins_at) {
    std::vector<FeatureSource> all{cylinder("disc", 50, 10)};
    for (int k = 0; k < 6; ++k)
      all.push_back(placed(cylinder("pin" + std::to_string(k), 3, 14), 8.0 * k - 20, pins_at, 2));
    all.push_back(
        placed(test::feature("groove", "torus", {{"major_radius", 50.0}, {"minor_radius", depth}}),
               0, 0, 5, Nature::Subtractive));
    return test::model_of(all);
  };
  const ModelSource base = with_groove(2, 0);
  EXPECT_EQ(told(with_groove(2.5, 0), base).back(), "fused in part") << "the disc and the groove";
  EXPECT_EQ(told(with_groove(2, 1), base).back(), "swept") << "pins within a ring that stays";
  expect_same_both_ways(base, with_groove(2.5, 0), "a groove round pins");
  expect_same_both_ways(base, with_groove(2, 1), "pins in a grooved disc");
}

TEST(StitchTest, FarFromTheBasesPointOfReferenceAllIsFused) {
  const auto block_at = [](double x) {
    return test::model_of({placed(block("b", 1, 1, 1), x, 0, 0)});
  };
  EXPECT_THAT(told(block_at(5), block_at(0)), ElementsAre("swept"));
  const std::string far = ": sew: the base's point of reference is far from the model";
  EXPECT_THAT(told(block_at(20), block_at(0)),
              ElementsAre("swept" + far, "crossed" + far, "fused in part" + far, "none"));
}

TEST(StitchTest, CellsAreThereWhenAskedFor) {
  const ModelSource plate = test::plate_with_grid(10);
  const ModelSource edited = test::with_moved(plate, "f5", 1, 0, 0);
  const Made made(edited, Made(plate));
  double volume = 0;
  for (const Cell& cell : made.cells.complex().cells) volume += cell.positive ? cell.volume : 0;
  EXPECT_NEAR(volume, made.cells.volume, 1e-8);
  EXPECT_EQ(&made.cells.complex(), &made.cells.complex());
}

}  // namespace
}  // namespace remeshd
