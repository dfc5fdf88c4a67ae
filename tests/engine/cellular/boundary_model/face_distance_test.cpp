#include "engine/cellular/boundary_model/face_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random.h"

namespace remeshd {
namespace {

/// The same from very many points of the triangle.
double sampled_distance(const std::vector<Vec3>& corners, const Vec3& p) {
  constexpr int kSteps = 200;
  double best = HUGE_VAL;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const double s = static_cast<double>(i) / kSteps, t = static_cast<double>(j) / kSteps;
      best =
          std::min(best, distance(p, (1 - s - t) * corners[0] + s * corners[1] + t * corners[2]));
    }
  return best;
}

TEST(FaceDistance, IsThatOfTheNearestPointOfItsTriangle) {
  Random random(1);
  const auto point = [&](double within) {
    return within * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  for (int k = 0; k < 200; ++k) {
    BoundaryFace face;
    face.points = {point(1), point(1), point(1)};
    face.triangles = {{0, 1, 2}};
    const Vec3 p = point(2);
    const double exact = std::sqrt(face_distance2(face, p));
    const double sampled = sampled_distance(face.points, p);
    EXPECT_LE(exact, sampled * (1 + 1e-12));
    EXPECT_GE(exact, sampled - 0.01) << k;
  }
}

TEST(FaceDistance, IsToTheNearestOfItsTriangles) {
  BoundaryFace face;
  face.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {1, 0, 3}, {0, 1, 3}};
  face.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_DOUBLE_EQ(face_distance2(face, {0.2, 0.2, 2}), 1);
  EXPECT_DOUBLE_EQ(face_distance2(face, {0.2, 0.2, 0.5}), 0.25);
}

}  // namespace
}  // namespace remeshd
