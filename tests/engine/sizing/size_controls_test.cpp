#include "engine/sizing/size_controls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "engine/sizing/reserve.h"
#include "engine/sizing/size_rules.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using test::kRun;

/// What the field is where a length is asked for.
double on_face(double length) { return length / kReserveOnFaces; }
double inside(double length) { return length / kReserveInside; }

/// A plate with a hole of radius 4, a cone on it, and a pin inside of the plate.
struct Plate {
  explicit Plate(std::vector<SizeControlSource> sizes) {
    ModelSource source = test::model_of(
        {test::block("plate", 60, 60, 8), test::placed(test::cylinder("inner", 2, 4), 20, 20, 2),
         test::placed(test::cylinder("hole", 4, 10), -15, 0, -1, Nature::Subtractive),
         test::placed(test::feature("tip", "cone",
                                    {{"radius_bottom", 6.0}, {"radius_top", 3.0}, {"height", 6.0}}),
                      15, 0, 8)});
    source.sizes = std::move(sizes);
    model = evaluate(source);
    cells = build_cells(model, kRun);
  }
  [[nodiscard]] SizeField field(double base = 5, std::optional<double> least = {}) const {
    const Sizing no_rules{.even = false, .edges_per_circle = 0, .layers = 0, .min_size = least};
    return SizeRules(cells.boundary, no_rules, base, kRun,
                     size_sources(model, cells.boundary, kRun))
        .field(base, 2);
  }
  FeatureModel model;
  CellularModel cells;
};

TEST(SizeControls, OnAFaceHoldThereAndGrowAwayFromIt) {
  const SizeField field = Plate({{"a", "hole.wall", "radius/4"}}).field();
  EXPECT_NEAR(field({-11, 0, 4}), on_face(1), 1e-9);
  EXPECT_NEAR(field({-15, 4, 0}), on_face(1), 0.01);  // the face's box is that of its triangles
  EXPECT_NEAR(field({-5, 0, 4}), on_face(1) + 0.3 * 6, 1e-9);
  EXPECT_EQ(field({29, 29, 4}), 5);
}

TEST(SizeControls, OnAPlaneFaceHoldAllOverIt) {
  const SizeField field = Plate({{"a", "plate.top", 1.0}}).field();
  EXPECT_NEAR(field({25, -25, 8}), on_face(1), 1e-9);
  EXPECT_NEAR(field({0, 0, 8}), on_face(1), 1e-9);
  EXPECT_NEAR(field({0, 25, 3}), on_face(1) + 0.3 * 5, 1e-9);
}

/// The field of a model on whose faces lengths are asked for, by no rule.
SizeField field_of(std::vector<FeatureSource> features, std::vector<SizeControlSource> sizes,
                   double base) {
  ModelSource source = test::model_of(std::move(features));
  source.sizes = std::move(sizes);
  const FeatureModel model = evaluate(source);
  const BoundaryModel boundary = build_cells(model, kRun).boundary;
  return SizeRules(boundary, {.even = false, .edges_per_circle = 0, .layers = 0}, base, kRun,
                   size_sources(model, boundary, kRun))
      .field(base, 1);
}

TEST(SizeControls, OnAFaceHoldOnNoOtherFeaturesFaceThatIsFlushWithIt) {
  // The top of the pad and that of the plate are one face of the boundary.
  const std::vector<FeatureSource> pad{test::block("plate", 100, 100, 20),
                                       test::placed(test::block("pad", 4, 4, 10), 20, 10, 10)};
  const SizeField on_pad = field_of(pad, {{"s", "pad.top", 1.0}}, 10);
  EXPECT_NEAR(on_pad({21, 9, 20}), on_face(1), 1e-6);
  EXPECT_NEAR(on_pad({40, 10, 20}), on_face(1) + 0.3 * 18, 0.15);
  EXPECT_EQ(on_pad({-45, -45, 20}), 10);
  const SizeField on_both = field_of(pad, {{"s", "*.top", 1.0}}, 10);
  EXPECT_NEAR(on_both({-45, -45, 20}), on_face(1), 1e-6);
  const SizeField uneven = field_of(pad, {{"s", "*.top", "dx/4"}}, 10);
  EXPECT_NEAR(uneven({21, 9, 20}), on_face(1), 1e-6);
  EXPECT_EQ(uneven({-45, -45, 20}), 10);
  // A seat on a shaft: its wall is the middle of the shaft's.
  const std::vector<FeatureSource> seat{test::cylinder("shaft", 10, 100),
                                        test::placed(test::cylinder("seat", 10, 8), 0, 0, 46)};
  const SizeField on_seat = field_of(seat, {{"s", "seat.wall", 1.0}}, 6);
  EXPECT_NEAR(on_seat({10, 0, 50}), on_face(1), 0.05);
  EXPECT_EQ(on_seat({10, 0, 10}), 6);
}

TEST(SizeControls, OnAPlaneFaceDoNotHoldUnderWhatStandsOnIt) {
  const SizeField field = field_of(
      {test::block("plate", 100, 100, 20), test::placed(test::block("boss", 80, 80, 10), 0, 0, 20)},
      {{"s", "plate.top", 2.0}}, 10);
  EXPECT_NEAR(field({45, 0, 20}), on_face(2), 1e-9);
  EXPECT_NEAR(field({30, 0, 20}), on_face(2) + 0.3 * 10, 1e-9);
  EXPECT_EQ(field({0, 0, 20}), 10);
}

TEST(SizeControls, OnAConeAreTheLengthItself) {
  const SizeField field = Plate({{"a", "tip.wall", 1.0}}).field();
  EXPECT_NEAR(field({21, 0, 8}), on_face(1), 1e-9);
  EXPECT_NEAR(field({18, 0, 14}), on_face(1), 1e-9);
}

TEST(SizeControls, InABallHoldAllThroughIt) {
  const SizeField field = Plate({{"a", BallSource{0.0, 0.0, 4.0, 5.0}, 0.75}}).field();
  EXPECT_NEAR(field({0, 0, 4}), inside(0.75), 1e-9);
  EXPECT_NEAR(field({4, 2, 5}), inside(0.75), 1e-9);
  EXPECT_NEAR(field({9, 0, 4}), inside(0.75) + 0.3 * 4, 1e-9);
}

TEST(SizeControls, InABoxHoldAllThroughIt) {
  const SizeField field = Plate({{"a", BoxSource{0.0, 0.0, 0.0, 10.0, 10.0, 2.0}, 0.75}}).field();
  EXPECT_NEAR(field({5, 5, 1}), inside(0.75), 1e-9);
  EXPECT_NEAR(field({0, 10, 0}), inside(0.75), 1e-9);
  EXPECT_NEAR(field({5, 5, 6}), inside(0.75) + 0.3 * 4, 1e-9);
  EXPECT_NEAR(field({5, 5, -2}), inside(0.75) + 0.3 * 2, 1e-9);
  EXPECT_NEAR(field({13, 14, 1}), inside(0.75) + 0.3 * 5, 1e-9);
}

TEST(SizeControls, OfSeveralTheLeastCounts) {
  const SizeField field =
      Plate({{"a", "hole", 2.0}, {"b", "hole.wall", 1.0}, {"c", "hole*", 3.0}}).field();
  EXPECT_NEAR(field({-11, 0, 4}), on_face(1), 1e-9);
}

TEST(SizeControls, GoBelowTheLeastLengthOfRules) {
  const SizeField field = Plate({{"a", "hole.wall", 0.25}}).field(5, 2.0);
  EXPECT_NEAR(field({-11, 0, 4}), on_face(0.25), 1e-9);
  EXPECT_EQ(field.least(), on_face(0.25));
}

TEST(SizeControls, OnAFeatureHoldInItsMaterial) {
  const SizeField field = Plate({{"a", "tip", 1.0}}).field();
  EXPECT_NEAR(field({15, 0, 11}), inside(1), 1e-9) << "2.4 from its wall";
  EXPECT_NEAR(field({15, 0, 8.4}), inside(1), 1e-9);
  EXPECT_NEAR(field({15, 0, 4}), inside(1) + 0.3 * 4, 0.3);
}

TEST(SizeControls, OnAFeatureThinnerThanTheLengthHoldInItsMaterial) {
  ModelSource source = test::model_of(
      {test::block("body", 40, 40, 20), test::placed(test::block("core", 30, 30, 1), 0, 0, 9.5)});
  source.sizes = {{"a", "core", 2.5}};
  const FeatureModel model = evaluate(source);
  const BoundaryModel boundary = build_cells(model, kRun).boundary;
  EXPECT_THAT(sizes_of_nothing(model, boundary, kRun), IsEmpty());
  const SizeField field = SizeRules(boundary, {.even = false, .edges_per_circle = 0, .layers = 0},
                                    5, kRun, size_sources(model, boundary, kRun))
                              .field(5, 2);
  for (const double x : {-14.9, 0.0, 14.9}) EXPECT_NEAR(field({x, -14.9, 10}), inside(2.5), 1e-9);
}

TEST(SizeControls, OfTooManyTrianglesAreRefused) {
  const Plate plate({{"a", "plate & sin(1e6*(x+y+z)) > 0", 0.01}});
  const ErrorInfo info =
      test::error_of([&] { (void)size_sources(plate.model, plate.cells.boundary, kRun); });
  EXPECT_EQ(info.parameter, "sizes.a.on");
}

TEST(SizeControls, OnManyFeaturesHaveABoundedNumberOfSources) {
  const Plate plate({{"a", "*", 0.01}, {"b", "tip | plate", 0.02}});
  EXPECT_LT(size_sources(plate.model, plate.cells.boundary, kRun).size(), 50'100U);
  EXPECT_NEAR(plate.field()({20, -20, 4}), inside(0.01), 1e-9);
}

TEST(SizeControls, OnAThinFeatureHaveABoundedNumberOfSources) {
  ModelSource source = test::model_of({test::block("sheet", 1000, 1000, 1e-3)});
  source.sizes = {{"a", "sheet", 1e-3}};
  const FeatureModel model = evaluate(source);
  EXPECT_LT(size_sources(model, build_cells(model, kRun).boundary, kRun).size(), 100'100U);
}

TEST(SizeControls, UnderAConditionHoldWhereItDoes) {
  const SizeField field = Plate({{"a", "plate.top & x < 0 && y > 10 | tip & z > 12", 1.0}}).field();
  EXPECT_NEAR(field({-20, 25, 8}), on_face(1), 1e-6);
  EXPECT_NEAR(field({-20, 4, 8}), on_face(1) + 0.3 * 6, 0.3);
  EXPECT_NEAR(field({18, 0, 13.5}), on_face(1), 0.1);
  EXPECT_NEAR(field({21, 0, 8}), on_face(1) + 0.3 * 4.2, 0.3);
}

TEST(SizeControls, ThatAskForMoreThanTheBaseSizeChangeNothing) {
  EXPECT_TRUE(Plate({{"a", "hole.wall", 6.0}, {"b", "tip.wall", 6.0}}).field().even());
}

TEST(SizeControls, OnFacesThatAreNotThereAreOfNothing) {
  const Plate plate({{"a", "hole.wall", 1.0},
                     {"b", "inner.wall", 1.0},
                     {"c", "gone*", 1.0},
                     {"e", "hole.wall & z > 30", 1.0},
                     {"d", BallSource{0.0, 0.0, 90.0, 1.0}, 1.0}});
  EXPECT_THAT(sizes_of_nothing(plate.model, plate.cells.boundary, kRun),
              ElementsAre("b", "c", "e"));
  EXPECT_THAT(sizes_of_nothing({}, plate.cells.boundary, kRun), IsEmpty());
  EXPECT_EQ(size_sources(plate.model, plate.cells.boundary, kRun).size(), 2U);
}

TEST(SizeControls, LongerThanAHollowFeatureAreOfItsMaterial) {
  // The ring is inside of the block, and the middle of its box is not in the ring.
  ModelSource source = test::model_of(
      {test::block("block", 40, 40, 20),
       test::placed(
           test::feature("ring", "torus", {{"major_radius", 4.0}, {"minor_radius", 1.0}}), 0, 0,
           10)});
  source.sizes = {{"a", "ring", 12.0}};
  const FeatureModel model = evaluate(source);
  EXPECT_THAT(sizes_of_nothing(model, build_cells(model, kRun).boundary, kRun), IsEmpty());
}

}  // namespace
}  // namespace remeshd
