#include "engine/boundary/cover/flat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace remeshd {
namespace {

using std::numbers::pi;

const Transform kPlaced =
    Transform::frame({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {5, -3, 2});  // z along x

/// Points of a patch of a surface, row by row, at parameters that go from `u0` to `u1` and from
/// `v0` to `v1`.
template <class At>
std::vector<Vec3> grid(const At& at, double u0, double u1, double v0, double v1, int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.push_back(kPlaced.apply(at(u0 + (u1 - u0) * i / n, v0 + (v1 - v0) * j / n)));
  return points;
}

double turn(const std::array<double, 2>& a, const std::array<double, 2>& b,
            const std::array<double, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// All triangles of the grid turn the same way in the plane: the map folds nothing. `round`: the
/// rows close.
void expect_unfolded(const Surface& surface, const std::vector<Vec3>& points, int n, bool round) {
  const auto map = FlatMap::of(surface, points);
  ASSERT_TRUE(map);
  int left = 0, right = 0;
  const auto at = [&](int i, int j) { return (*map)(points[(i % n) * n + j]); };
  for (int i = 0; i < (round ? n : n - 1); ++i)
    for (int j = 0; j + 1 < n; ++j)
      for (const double t : {turn(at(i, j), at(i + 1, j), at(i + 1, j + 1)),
                             turn(at(i, j), at(i + 1, j + 1), at(i, j + 1))})
        ++(t > 0 ? left : right);
  EXPECT_EQ(std::min(left, right), 0) << left << " " << right;
}

Vec3 on_cylinder(double u, double v) { return {2 * std::cos(u), 2 * std::sin(u), v}; }
Vec3 on_cone(double u, double v) {
  return {(3 - 0.5 * v) * std::cos(u), (3 - 0.5 * v) * std::sin(u), v};
}
Vec3 on_sphere(double u, double v) {
  return {2 * std::cos(u) * std::cos(v), 2 * std::sin(u) * std::cos(v), 2 * std::sin(v)};
}
Vec3 on_torus(double u, double v) {
  return {(5 + std::cos(v)) * std::cos(u), (5 + std::cos(v)) * std::sin(u), std::sin(v)};
}

using Kind = Surface::Kind;

TEST(FlatMap, APlaneKeepsItsLengths) {
  const Surface plane{Kind::Plane, kPlaced};
  const Vec3 a = kPlaced.apply({1, 2, 0}), b = kPlaced.apply({4, 6, 0});
  const auto map = FlatMap::of(plane, std::vector{a, b});
  ASSERT_TRUE(map);
  EXPECT_NEAR(std::hypot((*map)(a)[0] - (*map)(b)[0], (*map)(a)[1] - (*map)(b)[1]), 5, 1e-12);
}

TEST(FlatMap, WhatGoesRoundInPartIsUnrolled) {
  expect_unfolded({Kind::Cylinder, kPlaced, 2}, grid(on_cylinder, 2, 5, -4, 4, 9), 9, false);
  expect_unfolded({Kind::Cone, kPlaced, 3, -0.5}, grid(on_cone, 2, 5, 0, 5.5, 9), 9, false);
  expect_unfolded({Kind::Torus, kPlaced, 5, 1}, grid(on_torus, 2, 5, 2, 5, 9), 9, false);
}

TEST(FlatMap, WhatGoesAllRoundIsARing) {
  expect_unfolded({Kind::Cylinder, kPlaced, 2}, grid(on_cylinder, 0, 2 * pi, -4, 4, 9), 9, true);
  expect_unfolded({Kind::Cone, kPlaced, 3, -0.5}, grid(on_cone, 0, 2 * pi, 0, 5.5, 9), 9, true);
  expect_unfolded({Kind::Torus, kPlaced, 5, 1}, grid(on_torus, 0, 2 * pi, 2, 5, 9), 9, true);
}

TEST(FlatMap, ATubeOfATorusIsARingToo) {
  const auto across = [](double u, double v) { return on_torus(v, u); };
  expect_unfolded({Kind::Torus, kPlaced, 5, 1}, grid(across, 0, 2 * pi, 2, 5, 9), 9, true);
  EXPECT_FALSE(FlatMap::of({Kind::Torus, kPlaced, 5, 1}, grid(on_torus, 0, 2 * pi, 0, 2 * pi, 9)));
}

TEST(FlatMap, ALongCylinderStaysWithinWhatNumbersHold) {
  const auto points = grid(on_cylinder, 0, 2 * pi, -4000, 4000, 9);
  expect_unfolded({Kind::Cylinder, kPlaced, 2}, points, 9, true);
}

TEST(FlatMap, ASphereIsSeenFromWhereThePartIsNot) {
  expect_unfolded({Kind::Sphere, kPlaced, 2}, grid(on_sphere, 0, 2 * pi, -1.2, 0.9, 9), 9, true);
  expect_unfolded({Kind::Sphere, kPlaced, 2}, grid(on_sphere, 1, 4, -1.2, 1.2, 9), 9, false);
}

}  // namespace
}  // namespace remeshd
