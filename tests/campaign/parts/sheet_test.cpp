#include "tests/campaign/parts/sheet.h"

#include <gtest/gtest.h>

#include <vector>

namespace remeshd::campaign {
namespace {

Footprint disc(double x, double y, double radius, double detail = 1) {
  return {{x, y}, {x, y}, radius, detail};
}

TEST(Sheet, HasRoomApartFromItsRim) {
  const Sheet sheet{.half_x = 20, .half_y = 10};
  EXPECT_TRUE(sheet.has_room(std::vector{disc(0, 0, 9)}));
  EXPECT_FALSE(sheet.has_room(std::vector{disc(0, 0, 9.9)}));
  EXPECT_FALSE(sheet.has_room(std::vector{disc(18, 0, 3)}));
}

TEST(Sheet, OfARingHasRoomBetweenItsCircles) {
  const Sheet sheet{.radius = 20, .inner = 8};
  EXPECT_TRUE(sheet.has_room(std::vector{disc(14, 0, 5)}));
  EXPECT_FALSE(sheet.has_room(std::vector{disc(12, 0, 5)}));
  EXPECT_FALSE(sheet.has_room(std::vector{disc(16, 0, 5)}));
  EXPECT_FALSE(sheet.has_room(std::vector{Footprint{{-14, 1}, {14, 1}, 1, 1}}));
}

TEST(Sheet, KeepsDetailsApartByTheSmallerOne) {
  Sheet sheet{.half_x = 50, .half_y = 50};
  sheet.taken = {disc(0, 0, 10, 20)};
  EXPECT_TRUE(sheet.has_room(std::vector{disc(11.5, 0, 1, 1)}));
  EXPECT_FALSE(sheet.has_room(std::vector{disc(11.3, 0, 1, 1)}));
  EXPECT_FALSE(sheet.has_room(std::vector{disc(22, 0, 10, 20)}));
}

TEST(Gap, IsBetweenTheSegmentsAndNegativeWhereTheyCross) {
  const Footprint rib{{-10, 0}, {10, 0}, 1, 1};
  EXPECT_DOUBLE_EQ(gap(rib, disc(0, 5, 2)), 2);
  EXPECT_DOUBLE_EQ(gap(rib, disc(14, 3, 2)), 2);
  EXPECT_DOUBLE_EQ(gap(rib, {{0, -5}, {0, 5}, 1, 1}), -2);
}

}  // namespace
}  // namespace remeshd::campaign
