#include "tests/campaign/parts/drawing.h"

#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

Drawing drawing(const ModelSource& source) {
  const FeatureModel model = evaluate(source);
  return look_at_drawing(model, build_cells(model, remeshd::Run{}).boundary);
}

/// A plate of 6 with a hole of radius 2 and another of radius 4, `wall` apart.
ModelSource two_holes(double wall) {
  return test::model_of(
      {test::block("plate", 60, 40, 6),
       test::placed(test::cylinder("small", 2, 8), -6, 0, -1, Nature::Subtractive),
       test::placed(test::cylinder("large", 4, 8), wall, 0, -1, Nature::Subtractive)});
}

TEST(Drawing, OfHolesFarApartHasNothingNarrow) {
  EXPECT_EQ(drawing(two_holes(8)).narrowest, kNarrow);
}

TEST(Drawing, TellsAWallByTheSmallerOfTheDetailsBesideIt) {
  // A third of the small hole's diameter of 4 would be 1.33.
  const double narrowest = drawing(two_holes(0.8)).narrowest;
  EXPECT_LT(narrowest, 0.25);
  EXPECT_GE(narrowest, 0.8 / 4);
}

TEST(Drawing, TellsAGapBetweenBosses) {
  const ModelSource part = test::model_of({test::block("plate", 60, 40, 6),
                                           test::placed(test::block("left", 8, 8, 8), -4.5, 0, 6),
                                           test::placed(test::block("right", 8, 8, 8), 4.5, 0, 6)});
  EXPECT_NEAR(drawing(part).narrowest, 1.0 / 8, 1e-9);
}

TEST(Drawing, OfAWedgeHasNothingNarrowWhereItsFacesMeet) {
  const ModelSource part = test::model_of({test::feature(
      "wedge", "prism", {test::point(0.0, 0.0), test::point(60.0, 0.0), test::point(0.0, 30.0)},
      {{"height", 20.0}})});
  EXPECT_EQ(drawing(part).narrowest, kNarrow);
}

TEST(Drawing, TellsAnEdgeThatIsASliver) {
  ModelSource part = test::model_of(
      {test::block("plate", 60, 40, 6), test::placed(test::block("step", 20, 20, 3), 20.2, 0, 6)});
  EXPECT_NEAR(drawing(part).narrowest, 0.2 / 3, 1e-9);
}

TEST(Drawing, CountsPairsThatTouch) {
  ModelSource part = two_holes(8);
  EXPECT_EQ(drawing(part).touching, 0);
  const BoundaryModel boundary = build_cells(evaluate(part), remeshd::Run{}).boundary;
  // Inside the material, where it changes no boundary, against the wall of the small hole.
  part.features.push_back(test::placed(test::cylinder("core", 3, 4), -1, 0, 1));
  EXPECT_EQ(look_at_drawing(evaluate(part), boundary).touching, 1);
}

TEST(Drawing, IsAsGoodAsOneThatIsNoBetter) {
  EXPECT_TRUE((Drawing{.narrowest = 0.2}).as_good_as({.narrowest = 0.2}));
  EXPECT_TRUE((Drawing{.narrowest = kNarrow}).as_good_as({.narrowest = 0.2}));
  EXPECT_FALSE((Drawing{.narrowest = 0.19}).as_good_as({.narrowest = 0.2}));
  EXPECT_FALSE((Drawing{.touching = 1}).as_good_as({}));
}

}  // namespace
}  // namespace remeshd::campaign
