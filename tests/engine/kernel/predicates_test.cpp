#include "engine/kernel/predicates.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace remeshd::kernel
