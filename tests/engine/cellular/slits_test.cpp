#include "engine/cellular/slits.h"

#include <gtest/gtest.h>

#include "tests/engine/cellular/simple_features.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

/// A block on a plate, so far in from the plate's edge.
BoundaryModel block_on_plate(double inset) {
  return cells_of({test::block("plate", 20, 20, 4),
                   test::placed(test::block("block", 10, 10, 6), -5 + inset, 0, 2)})
      .boundary;
}

TEST(Slits, AreStepsNarrowerThanAsked) {
  EXPECT_FALSE(has_slits(block_on_plate(0), 1e-2)) << "flush";
  EXPECT_FALSE(has_slits(block_on_plate(0.2), 1e-2));
  EXPECT_TRUE(has_slits(block_on_plate(0.005), 1e-2)) << "a ledge of the plate";
  EXPECT_TRUE(has_slits(block_on_plate(-0.005), 1e-2)) << "the block stands out";
}

TEST(Slits, AreFilmsBetweenAHoleAndAWall) {
  const auto plate_with_hole = [](double wall) {
    return cells_of(
               {test::block("plate", 20, 20, 4),
                test::placed(test::cylinder("hole", 3, 6), 7 - wall, 0, -1, Nature::Subtractive)})
        .boundary;
  };
  EXPECT_FALSE(has_slits(plate_with_hole(0.5), 1e-2));
  EXPECT_TRUE(has_slits(plate_with_hole(0.005), 1e-2));
}

TEST(Slits, AreEdgesShorterThanAsked) {
  const auto wedge = [](double back) {
    return cells_of({test::feature("wedge", "prism",
                                   {test::point(0.0, 0.0), test::point(30.0, -back / 2),
                                    test::point(30.0, back / 2)},
                                   {{"height", 40.0}})})
        .boundary;
  };
  EXPECT_TRUE(has_slits(wedge(0.005), 1e-2));
  EXPECT_FALSE(has_slits(wedge(2), 1e-2)) << "an edge meets the faces at its ends";
}

}  // namespace
}  // namespace remeshd
