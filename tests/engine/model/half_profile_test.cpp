#include <gtest/gtest.h>

#include "engine/model/expression.h"
#include "engine/model/profile.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using test::arc;
using test::point;
using Entries = std::vector<ProfileEntry>;

std::vector<ProfileSide> half_outline(const Entries& entries, bool full_turn = true) {
  return evaluate_half_profile(entries, full_turn, Scope({}), "ring");
}
std::string half_failure_of(const Entries& entries, bool full_turn = true) {
  return test::place_of(test::error_of([&] { half_outline(entries, full_turn); }));
}

TEST(HalfProfile, StaysOnOneSideOfTheAxis) {
  EXPECT_EQ(half_failure_of({point(1.0, 0.0), point(2.0, 0.0), point(-0.1, 1.0)}),
            "PROFILE_CROSSES_AXIS ring profile[2]");
  const auto hollow = [](double tx) {
    return Entries{point(1.0, 0.0), point(3.0, 2.0), point(1.0, 4.0), arc(1.0, 0.0, tx, 2.0)};
  };
  EXPECT_EQ(half_failure_of(hollow(-0.5)), "PROFILE_CROSSES_AXIS ring profile[3]");
  EXPECT_EQ(half_failure_of(hollow(0)), "PROFILE_CROSSES_AXIS ring profile[3]");
  EXPECT_EQ(half_failure_of(hollow(0), false), "PROFILE_CROSSES_AXIS ring profile[3]");
  EXPECT_NO_THROW(half_outline(hollow(0.1)));
}

TEST(HalfProfile, CoordinatesWithinRoundingOfTheAxisAreOnIt) {
  const auto sides =
      half_outline({point(1e-12, 0.0), point(2.0, 0.0), point(2.0, 1.0), point(-1e-12, 1.0)});
  EXPECT_EQ(sides[0].from[0], 0);
  EXPECT_EQ(sides[3].from[0], 0);
  EXPECT_EQ(sides[3].to[0], 0);
}

TEST(HalfProfile, ACornerAloneOnTheAxisPinchesAFullTurn) {
  const Entries pinched{point(0.0, 0.0), point(2.0, -1.0), point(2.0, 1.0)};
  EXPECT_EQ(half_failure_of(pinched), "PROFILE_CROSSES_AXIS ring profile[0]");
  EXPECT_NO_THROW(half_outline(pinched, false));
  // With a side on the axis the same corner is the tip of a cone.
  EXPECT_NO_THROW(half_outline({point(0.0, 0.0), point(2.0, 1.0), point(0.0, 1.0)}));
}

TEST(HalfProfile, AHalfDiscOnTheAxisIsABall) {
  EXPECT_EQ(half_outline({point(0.0, -2.0), arc(0.0, 2.0, 2.0, 0.0)}).size(), 2U);
}

}  // namespace
}  // namespace remeshd
