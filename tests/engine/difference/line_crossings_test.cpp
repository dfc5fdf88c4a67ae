#include "engine/difference/line_crossings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random.h"
#include "tests/support/random_frame.h"

namespace remeshd {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using Kind = Surface::Kind;

std::vector<double> crossings(const Surface& surface, const Line& line) {
  std::vector<double> out;
  append_crossings(surface, line, out);
  std::ranges::sort(out);
  return out;
}

TEST(LineCrossings, OfATorusAreFourInItsPlaneAndTwoBesideItsHole) {
  const Surface torus{Kind::Torus, Transform{}, 4, 1};
  EXPECT_THAT(crossings(torus, {{-10, 0, 0}, {1, 0, 0}, 0, 20}),
              ElementsAre(DoubleNear(5, 1e-9), DoubleNear(7, 1e-9), DoubleNear(13, 1e-9),
                          DoubleNear(15, 1e-9)));
  EXPECT_THAT(crossings(torus, {{4, 0, -10}, {0, 0, 1}, 0, 20}),
              ElementsAre(DoubleNear(9, 1e-9), DoubleNear(11, 1e-9)));
  EXPECT_THAT(crossings(torus, {{-10, 0, 0}, {1, 0, 0}, 6, 14}),
              ElementsAre(DoubleNear(7, 1e-9), DoubleNear(13, 1e-9)))
      << "of a shorter line";
  EXPECT_THAT(crossings(torus, {{0, 0, -10}, {0, 0, 1}, 0, 20}), ElementsAre());
}

TEST(LineCrossings, LieOnTheSurfaceAndAreAsManyAsTheSidesChange) {
  Random random(7);
  for (const Surface& surface : {Surface{Kind::Plane, test::random_frame(random), 0, 0},
                                 Surface{Kind::Cylinder, test::random_frame(random), 3, 0},
                                 Surface{Kind::Sphere, test::random_frame(random), 5, 0},
                                 Surface{Kind::Torus, test::random_frame(random), 4, 1.5}}) {
    std::size_t found = 0, changes = 0;
    for (int k = 0; k < 20; ++k) {
      const Line line{surface.frame.apply(test::random_point(random, 4)),
                      normalised(test::random_point(random, 1)), -20, 20};
      const auto at = [&](double t) { return line.p + t * line.direction; };
      for (const double t : crossings(surface, line)) {
        EXPECT_NEAR(signed_distance(surface, at(t)), 0, 1e-6);
        ++found;
      }
      for (int i = -20000; i < 20000; ++i)
        changes += (signed_distance(surface, at(1e-3 * i)) < 0) !=
                   (signed_distance(surface, at(1e-3 * (i + 1))) < 0);
    }
    EXPECT_EQ(found, changes);
    EXPECT_GT(found, 0U);
  }
}

}  // namespace
}  // namespace remeshd
