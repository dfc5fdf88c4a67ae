#include "engine/base/region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random.h"

namespace remeshd {
namespace {

std::vector<Vec3> cloud(int n, const Vec3& centre, Random& random) {
  std::vector<Vec3> points(n);
  for (Vec3& p : points)
    p = centre + Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return points;
}

double distance_to(const std::vector<Vec3>& points, const Vec3& p) {
  double d = HUGE_VAL;
  for (const Vec3& q : points) d = std::fmin(d, distance(p, q));
  return d;
}

TEST(Region, HoldsWhatIsInReachAndNothingMuchFurther) {
  Random random(1);
  const std::vector<Vec3> points = cloud(20, {}, random);
  for (const int steps : {1, 2, 4}) {
    const Region region(points, 0.5, steps);
    for (const Vec3& p : cloud(2000, {}, random)) {
      const double d = distance_to(points, 3 * p);
      if (d <= 0.5) {
        EXPECT_TRUE(region.holds(3 * p));
      }
      if (d > 0.5 * std::sqrt(3.0) * (1 + 1.0 / steps)) {
        EXPECT_FALSE(region.holds(3 * p));
      }
    }
  }
}

TEST(Region, MeetsBoxesWithPointsThatItHolds) {
  Random random(2);
  const Region region(cloud(5, {}, random), 0.2, 1);
  int held = 0, missed = 0;
  for (int k = 0; k < 200; ++k) {
    Box box;
    for (const Vec3& p : cloud(2, 3 * cloud(1, {}, random)[0], random)) box.add(0.5 * p);
    bool holds_some = false;
    for (const Vec3& p : cloud(500, {}, random)) {
      const Vec3 half = 0.5 * (box.hi - box.lo), centre = 0.5 * (box.lo + box.hi);
      const Vec3 q = centre + Vec3{half.x * p.x, half.y * p.y, half.z * p.z};
      holds_some = holds_some || region.holds(q);
    }
    if (holds_some) {
      EXPECT_TRUE(region.meets(box));
    }
    held += holds_some ? 1 : 0;
    missed += region.meets(box) ? 0 : 1;
  }
  EXPECT_GT(held, 20);
  EXPECT_GT(missed, 20);
  EXPECT_FALSE(region.meets({{50, 50, 50}, {51, 51, 51}}));
  EXPECT_FALSE(Region({}, 1, 1).meets({{-1, -1, -1}, {1, 1, 1}}));
  const std::vector<Vec3> one{{1, 2, 3}};
  EXPECT_TRUE(Region(one, 1e-9, 1).meets({one[0], one[0]}));
}

TEST(Region, HasABoxRoundEachPart) {
  Random random(3);
  std::vector<Vec3> points = cloud(10, {}, random);
  const std::vector<Vec3> other = cloud(10, {10, 0, 0}, random);
  points.insert(points.end(), other.begin(), other.end());
  const Region region(points, 1, 2);
  EXPECT_EQ(region.boxes().size(), 2U);
  for (const Vec3& p : points)
    EXPECT_TRUE(std::ranges::any_of(region.boxes(), [&](const Box& b) { return b.contains(p); }));
}

TEST(Region, OfNothingHoldsNothing) {
  const Region region({}, 1, 2);
  EXPECT_FALSE(region.holds({}));
  EXPECT_TRUE(region.boxes().empty());
}

}  // namespace
}  // namespace remeshd
