#include "engine/nodes/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random.h"

namespace remeshd {
namespace {

const Box kEverywhere{{-10, -10, -10}, {10, 10, 10}};

std::vector<Vec3> cloud(int n, double half, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points(n);
  for (Vec3& p : points)
    p = {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
  return points;
}

double distance_to(const std::vector<Vec3>& points, const Vec3& p) {
  double least = HUGE_VAL;
  for (const Vec3& q : points) least = std::min(least, distance(p, q));
  return least;
}

TEST(Surroundings, HoldWhatIsWithinReach) {
  const std::vector<Vec3> points = cloud(30, 1, 1);
  const Surroundings around(points, 0.5, kEverywhere);
  for (const Vec3& p : cloud(3000, 2, 2)) EXPECT_EQ(around.holds(p), distance_to(points, p) <= 0.5);
}

TEST(Surroundings, MeetBallsThatReachThemAndNoneThatAreFar) {
  const std::vector<Vec3> points = cloud(30, 1, 3);
  const Surroundings around(points, 0.5, kEverywhere);
  Random random(4);
  int met = 0, missed = 0;
  for (const Vec3& centre : cloud(2000, 4, 5)) {
    const double radius = random.uniform(0, 2);
    const double gap = distance_to(points, centre) - radius - 0.5;
    if (gap <= 0) {
      EXPECT_TRUE(around.meets(centre, radius));
    }
    if (gap > 0.5 * 3) {
      EXPECT_FALSE(around.meets(centre, radius));
    }
    ++(gap <= 0 ? met : missed);
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(missed, 100);
}

TEST(Surroundings, MeetBallsWithoutACentreAndNothingBeyondTheirBox) {
  const std::vector<Vec3> points{{0, 0, 0}};
  EXPECT_TRUE(Surroundings(points, 1, kEverywhere).meets({NAN, 0, 0}, NAN));
  EXPECT_TRUE(Surroundings(points, 1, kEverywhere).meets({0, 0, 3}, 2.5));
  EXPECT_FALSE(Surroundings(points, 1, {{-1, -1, -1}, {1, 1, 0}}).meets({0, 0, 3}, 2.5));
  EXPECT_FALSE(Surroundings({}, 1, kEverywhere).meets({0, 0, 0}, 1));
  EXPECT_FALSE(Surroundings({}, 1, kEverywhere).holds({0, 0, 0}));
}

TEST(Surroundings, MayHoldSomeOfEveryBoxWithAPointThatTheyHold) {
  const std::vector<Vec3> points = cloud(30, 1, 3);
  // A box that leaves some of them out: what they hold does not depend on it.
  const Surroundings around(points, 0.5, {{-1, -1, -1}, {1, 1, 0}});
  Random random(6);
  int may = 0, may_not = 0;
  for (const Vec3& p : cloud(2000, 4, 7)) {
    Box box;
    box.add(p);
    EXPECT_TRUE(!around.holds(p) || around.may_hold_some_of(box));
    box.add(p + Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    EXPECT_TRUE(!around.holds(p) || around.may_hold_some_of(box));
    ++(around.may_hold_some_of(box) ? may : may_not);
  }
  EXPECT_GT(may, 100);
  EXPECT_GT(may_not, 100);
}

}  // namespace
}  // namespace remeshd
