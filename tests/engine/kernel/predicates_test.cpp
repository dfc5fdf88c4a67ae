#include "engine/kernel/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "engine/base/random.h"

namespace remeshd::kernel {
namespace {

TEST(Predicates, APositiveTetHasItsFourthCornerOnTheSideOfTheNormal) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, -3, 0}), 0);
}

TEST(Predicates, TheCircumsphereOfThePositiveUnitTetIsKnown) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  EXPECT_EQ(in_sphere(a, b, c, d, {0.5, 0.5, 0.5}), 1);
  EXPECT_EQ(in_sphere(a, b, c, d, {1, 1, 1}), 0);
  EXPECT_EQ(in_sphere(a, b, c, d, {1.0001, 1, 1}), -1);
}

TEST(Predicates, FilterAndExactArithmeticAgreeWhereTheFilterDecides) {
  Random random(7);
  const auto point = [&] {
    return Vec3{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
  };
  for (int k = 0; k < 2000; ++k) {
    const Vec3 a = point(), b = point(), c = point();
    Vec3 d = point();
    const Vec3 p = point();
    ASSERT_EQ(orientation(a, b, c, d), exact_orientation(a, b, c, d));
    if (orientation(a, b, c, d) < 0) d = a + b - d + c - p;
    if (orientation(a, b, c, d) <= 0) continue;
    ASSERT_EQ(in_sphere(a, b, c, d, p), exact_in_sphere(a, b, c, d, p));
  }
}

TEST(Predicates, ASingleBitOffAPlaneIsSeen) {
  const double z = 0.1;
  EXPECT_EQ(orientation({0, 0, z}, {1, 0, z}, {0, 1, z}, {0.3, 0.3, std::nextafter(z, 1.0)}), 1);
  EXPECT_EQ(orientation({0, 0, z}, {1, 0, z}, {0, 1, z}, {0.3, 0.3, std::nextafter(z, 0.0)}), -1);
}

struct Case {
  std::vector<Vec3> tet;
  Vec3 p;
};

/// A positive tet with corners that `draw` gives, and a point; four in a plane are drawn again.
template <class Draw>
Case drawn(const Draw& draw) {
  while (true) {
    Case c{{draw(), draw(), draw(), draw()}, draw()};
    const int turn = orientation(c.tet[0], c.tet[1], c.tet[2], c.tet[3]);
    if (turn < 0) std::swap(c.tet[2], c.tet[3]);
    if (turn != 0) return c;
  }
}

/// How many of the cases the sphere test leaves open; in all others it says what the exact test
/// says, as `in_sphere` and the filter behind it always do.
template <class Draw>
int left_open(int count, const Draw& draw) {
  int open = 0;
  for (int k = 0; k < count; ++k) {
    const auto [t, p] = drawn(draw);
    const int exact = exact_in_sphere(t[0], t[1], t[2], t[3], p);
    EXPECT_EQ(in_sphere(t[0], t[1], t[2], t[3], p), exact);
    EXPECT_EQ(filtered_in_sphere(t[0], t[1], t[2], t[3], p), exact);
    const int side = SphereTest(t[0], t[1], t[2], t[3]).side(p);
    if (side == 0)
      ++open;
    else
      EXPECT_EQ(side, exact);
  }
  return open;
}

TEST(SphereTest, SaysOfPointsAnywhereWhatTheExactTestSays) {
  Random random(1);
  const auto coordinate = [&] { return random.uniform(-1, 1); };
  const int open = left_open(20000, [&] { return Vec3{coordinate(), coordinate(), coordinate()}; });
  EXPECT_LT(open, 5);
}

TEST(SphereTest, SaysOfLatticePointsWhatTheExactTestSaysOrLeavesThemOpen) {
  // Far from the origin, so that coordinates are rounded; very many points lie on the sphere.
  Random random(2);
  const auto coordinate = [&] { return 1000 + 0.1 * std::floor(random.uniform(0, 4)); };
  const int open = left_open(20000, [&] { return Vec3{coordinate(), coordinate(), coordinate()}; });
  EXPECT_GT(open, 200);
}

TEST(SphereTest, SaysOfPointsNearASphereWhatTheExactTestSaysOrLeavesThemOpen) {
  for (const double off : {1e-8, 1e-10, 1e-12, 1e-14, 1e-16}) {
    Random random(3);
    const auto coordinate = [&] { return random.uniform(-1, 1); };
    const int open = left_open(4000, [&] {
      const Vec3 p = normalised(Vec3{coordinate(), coordinate(), coordinate()});
      return (1 + off * coordinate()) * p + Vec3{0.3, -7, 2};
    });
    if (off >= 1e-8) {
      EXPECT_LT(open, 400);
    }
    if (off <= 1e-14) {
      EXPECT_GT(open, 3600);
    }
  }
}

}  // namespace
}  // namespace remeshd::kernel
