#include "engine/second_order/jacobian.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random.h"

namespace remeshd {
namespace {

QuadraticTet straight(const std::array<Vec3, 4>& corners) {
  QuadraticTet tet{corners, {}};
  for (std::size_t k = 0; k < 6; ++k)
    tet.mids[k] = 0.5 * (corners[kTetEdges[k][0]] + corners[kTetEdges[k][1]]);
  return tet;
}

constexpr std::array<Vec3, 4> kCorners{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0.3, 1.5, 0},
                                       Vec3{0.2, 0.4, 1.8}};

/// The point of the tet with these barycentric coordinates.
Vec3 point_of(const QuadraticTet& tet, const std::array<double, 4>& at) {
  Vec3 p;
  for (int k = 0; k < 4; ++k) p += at[k] * (2 * at[k] - 1) * tet.corners[k];
  for (int k = 0; k < 6; ++k) p += 4 * at[kTetEdges[k][0]] * at[kTetEdges[k][1]] * tet.mids[k];
  return p;
}

/// By differences of points; exact but for rounding, for the map is quadratic.
double jacobian_at(const QuadraticTet& tet, const std::array<double, 4>& at) {
  constexpr double kStep = 1e-3;
  std::array<Vec3, 3> columns;
  for (int k = 0; k < 3; ++k) {
    std::array<double, 4> more = at, less = at;
    more[k + 1] += kStep, more[0] -= kStep;
    less[k + 1] -= kStep, less[0] += kStep;
    columns[k] = (point_of(tet, more) - point_of(tet, less)) / (2 * kStep);
  }
  return dot(cross(columns[0], columns[1]), columns[2]);
}

double least_of_many(const QuadraticTet& tet, const std::array<Vec3, 4>& c) {
  double least = HUGE_VAL;
  constexpr int kParts = 20;
  for (int i = 0; i <= kParts; ++i)
    for (int j = 0; i + j <= kParts; ++j)
      for (int k = 0; i + j + k <= kParts; ++k) {
        const double n = kParts;
        least = std::min(least, jacobian_at(tet, {i / n, j / n, k / n, (kParts - i - j - k) / n}));
      }
  return least / dot(cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0]);
}

TEST(Jacobian, OfStraightEdgesIsTheTetsOwn) {
  EXPECT_DOUBLE_EQ(least_jacobian(straight(kCorners)), 1);
}

TEST(Jacobian, IsNowhereLessThanTheBoundAndNotMuchMore) {
  Random random(3);
  int turned = 0;
  for (int k = 0; k < 200; ++k) {
    QuadraticTet tet = straight(kCorners);
    for (Vec3& mid : tet.mids)
      mid += Vec3{random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25),
                  random.uniform(-0.25, 0.25)};
    const double bound = least_jacobian(tet), least = least_of_many(tet, kCorners);
    EXPECT_LE(bound, least + 1e-9);
    EXPECT_GE(bound, least - 0.5);
    turned += least < 0 ? 1 : 0;
  }
  EXPECT_GT(turned, 10);
}

TEST(Jacobian, OfATetThatIsTurnedOverAtACornerIsNegative) {
  QuadraticTet tet = straight(kCorners);
  tet.mids[0] = tet.corners[0] + 0.2 * (tet.corners[1] - tet.corners[0]);  // less than a quarter
  EXPECT_LT(least_jacobian(tet), 0);
}

}  // namespace
}  // namespace remeshd
