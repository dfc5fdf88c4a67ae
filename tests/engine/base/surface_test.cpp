#include "engine/base/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/random_frame.h"

namespace remeshd {
namespace {

using Kind = Surface::Kind;
constexpr double kPi = std::numbers::pi;

struct Named {
  std::string name;
  Surface surface;
};

std::vector<Named> all_kinds() {
  Random random(11);
  const auto framed = [&](Kind kind, double r1, double r2) {
    return Surface{kind, test::random_frame(random), r1, r2};
  };
  return {{"plane", framed(Kind::Plane, 0, 0)},   {"cylinder", framed(Kind::Cylinder, 3, 0)},
          {"cone", framed(Kind::Cone, 2, 0.7)},   {"narrowing cone", framed(Kind::Cone, 4, -1.5)},
          {"sphere", framed(Kind::Sphere, 5, 0)}, {"torus", framed(Kind::Torus, 4, 1.5)},
          {"apple", framed(Kind::Torus, 1, 3)},   {"lemon", framed(Kind::Torus, -1, 3)}};
}

/// Points of the surface in its own frame, within about 20 of the origin, fine enough that every
/// point there has one nearer than 0.2.
std::vector<Vec3> sampled(const Surface& s) {
  std::vector<Vec3> points;
  constexpr int kTurns = 400;
  const auto ring = [&](double rho, double z) {
    for (int k = 0; k < kTurns; ++k) {
      const double t = 2 * kPi * k / kTurns;
      points.push_back({rho * std::cos(t), rho * std::sin(t), z});
    }
  };
  for (int i = -200; i <= 200; ++i) {
    const double z = 0.1 * i;
    const double t = kPi * i / 200;
    switch (s.kind) {
      case Kind::Plane:
        for (int j = -200; j <= 200; ++j) points.push_back({0.1 * i, 0.1 * j, 0});
        break;
      case Kind::Cylinder:
        ring(s.r1, z);
        break;
      case Kind::Cone:
        if (s.r1 + s.r2 * z >= 0) ring(s.r1 + s.r2 * z, z);
        break;
      case Kind::Sphere:
        ring(s.r1 * std::sin(t / 2 + kPi / 2), s.r1 * std::cos(t / 2 + kPi / 2));
        break;
      case Kind::Torus:
        if (s.r1 + s.r2 * std::cos(t) >= 0) ring(s.r1 + s.r2 * std::cos(t), s.r2 * std::sin(t));
        break;
    }
  }
  return points;
}

TEST(Surface, ProjectionIsNearerThanAnySampledPointAndNoFartherThanTheSpacingAllows) {
  for (const auto& [name, surface] : all_kinds()) {
    const std::vector<Vec3> samples = sampled(surface);
    Random random(3);
    for (int k = 0; k < 60; ++k) {
      const Vec3 local = test::random_point(random, 7);
      const Vec3 p = surface.frame.apply(local);
      double nearest = HUGE_VAL;
      for (const Vec3& s : samples) nearest = std::min(nearest, distance(local, s));
      const double d = distance(p, project(surface, p));
      EXPECT_LE(d, nearest + 1e-12) << name;
      EXPECT_GE(d, nearest - 0.3) << name;
      EXPECT_NEAR(d, std::fabs(signed_distance(surface, p)), 1e-12) << name;
    }
  }
}

TEST(Surface, ProjectionLiesOnTheSurfaceAndProjectingAgainStaysThere) {
  for (const auto& [name, surface] : all_kinds()) {
    Random random(4);
    for (int k = 0; k < 200; ++k) {
      const Vec3 p = surface.frame.apply(test::random_point(random, 9));
      const Vec3 q = project(surface, p);
      EXPECT_NEAR(signed_distance(surface, q), 0, 1e-13 * 20) << name;
      EXPECT_LE(distance(project(surface, q), q), 1e-13 * 20) << name;
    }
  }
}

TEST(Surface, NormalIsTheGradientOfTheSignedDistance) {
  for (const auto& [name, surface] : all_kinds()) {
    Random random(5);
    constexpr double h = 1e-6;
    for (int k = 0; k < 100; ++k) {
      const Vec3 p = surface.frame.apply(test::random_point(random, 7));
      const Vec3 n = normal(surface, p);
      EXPECT_NEAR(norm(n), 1, 1e-14) << name;
      // Beyond the tip of an apple or lemon the nearest point stays the tip itself.
      if (distance(p, project(surface, p) + signed_distance(surface, p) * n) > 1e-9) continue;
      const Vec3 gradient = Vec3{signed_distance(surface, p + Vec3{h, 0, 0}) -
                                     signed_distance(surface, p - Vec3{h, 0, 0}),
                                 signed_distance(surface, p + Vec3{0, h, 0}) -
                                     signed_distance(surface, p - Vec3{0, h, 0}),
                                 signed_distance(surface, p + Vec3{0, 0, h}) -
                                     signed_distance(surface, p - Vec3{0, 0, h})} /
                            (2 * h);
      EXPECT_LE(distance(gradient, n), 1e-5) << name;
    }
  }
}

bool is_apex(const Surface& cone, const Vec3& p) {
  return distance(p, cone.frame.apply({0, 0, -cone.r1 / cone.r2})) < 1e-12;
}

TEST(Surface, PointIsItsFootPlusDistanceAlongTheNormal) {
  for (const auto& [name, surface] : all_kinds()) {
    if (name == "apple" || name == "lemon") continue;
    Random random(6);
    for (int k = 0; k < 100; ++k) {
      const Vec3 p = surface.frame.apply(test::random_point(random, 7));
      const Vec3 foot = project(surface, p);
      if (name.ends_with("cone") && is_apex(surface, foot)) continue;
      const Vec3 back = foot + signed_distance(surface, p) * normal(surface, p);
      EXPECT_LE(distance(back, p), 1e-12) << name;
    }
  }
}

TEST(Surface, WhereManyPointsAreNearestTheOneAlongLocalXIsTaken) {
  const Transform at{};
  EXPECT_EQ(project({Kind::Cylinder, at, 3, 0}, {0, 0, 2}), (Vec3{3, 0, 2}));
  EXPECT_EQ(project({Kind::Sphere, at, 3, 0}, {0, 0, 0}), (Vec3{3, 0, 0}));
  EXPECT_EQ(project({Kind::Torus, at, 4, 1}, {4, 0, 0}), (Vec3{5, 0, 0}));
  EXPECT_EQ(normal({Kind::Cylinder, at, 3, 0}, {0, 0, 2}), (Vec3{1, 0, 0}));
  EXPECT_EQ(normal({Kind::Sphere, at, 3, 0}, {0, 0, 0}), (Vec3{1, 0, 0}));
  const Vec3 on_cone = project({Kind::Cone, at, 2, 1}, {0, 0, 0});
  EXPECT_NEAR(distance(on_cone, {1, 0, -1}), 0, 1e-15);
}

TEST(Surface, SidesOfEachKindHaveTheSignOfTheNormal) {
  const Transform at{};
  EXPECT_DOUBLE_EQ(signed_distance({Kind::Plane, at, 0, 0}, {1, 2, -3}), -3);
  EXPECT_DOUBLE_EQ(signed_distance({Kind::Cylinder, at, 3, 0}, {0, 1, 8}), -2);
  EXPECT_DOUBLE_EQ(signed_distance({Kind::Sphere, at, 3, 0}, {0, 0, 5}), 2);
  EXPECT_DOUBLE_EQ(signed_distance({Kind::Torus, at, 4, 1}, {0, 0, 0}), 3);
  EXPECT_DOUBLE_EQ(signed_distance({Kind::Torus, at, 4, 1}, {0, 4, 0.25}), -0.75);
  EXPECT_DOUBLE_EQ(signed_distance({Kind::Cone, at, 2, 1}, {4, 0, 0}), std::sqrt(2.0));
}

TEST(Surface, ConeEndsAtItsApex) {
  const Surface cone{Kind::Cone, Transform{}, 2, 1};  // apex at z = -2
  const Vec3 apex{0, 0, -2};
  for (const Vec3& beyond : {Vec3{2, 0, -5}, Vec3{0, 0, -3}, Vec3{0, 2, -5}}) {
    EXPECT_EQ(project(cone, beyond), apex);
    EXPECT_DOUBLE_EQ(signed_distance(cone, beyond), distance(beyond, apex));
  }
  // Below the apex, and yet nearer to the side than to it.
  EXPECT_NEAR(distance(project(cone, {2, 0, -3}), {0.5, 0, -1.5}), 0, 1e-15);
  EXPECT_LT(signed_distance(cone, {0, 0, -1}), 0);
  EXPECT_LT(normal(cone, {2, 0, 0}).z, 0);
}

TEST(Surface, BendsAsTheSharperOfItsTwoCircles) {
  const Transform at{};
  EXPECT_EQ(radius_of_curvature({Kind::Plane, at, 0, 0}, {1, 2, 3}), HUGE_VAL);
  EXPECT_EQ(radius_of_curvature({Kind::Cylinder, at, 3, 0}, {3, 0, 1}), 3);
  EXPECT_EQ(radius_of_curvature({Kind::Sphere, at, 3, 0}, {0, 3, 0}), 3);
  EXPECT_DOUBLE_EQ(radius_of_curvature({Kind::Cone, at, 2, 0}, {2, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(radius_of_curvature({Kind::Cone, at, 5, -0.75}, {2, 0, 4}), 2.5);
  // Next to flat it hardly bends: it was taken for as round as its rim.
  EXPECT_NEAR(radius_of_curvature({Kind::Cone, at, 5, -1000}, {5, 0, 0}), 5000, 0.01);
  const Surface ring{Kind::Torus, at, 6, 5}, lemon{Kind::Torus, at, -90, 100};
  EXPECT_DOUBLE_EQ(radius_of_curvature(ring, {11, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(radius_of_curvature(ring, {1, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(radius_of_curvature(ring, {6, 0, 5}), 5);
  EXPECT_DOUBLE_EQ(radius_of_curvature(lemon, {10, 0, 0}), 10);
}

const Box kBox{{-20, -20, -20}, {20, 20, 20}};

TEST(SameSurface, HoldsForAnotherFrameOfTheSamePointSet) {
  for (const auto& [name, surface] : all_kinds()) {
    Surface other = surface;
    const Transform spin = Transform::frame({std::cos(1.0), std::sin(1.0), 0},
                                            {-std::sin(1.0), std::cos(1.0), 0}, {0, 0, 1}, {});
    other.frame = surface.frame * spin;
    EXPECT_TRUE(same_surface(surface, other, kBox, 1e-10)) << name;
  }
  const Transform flip = Transform::frame({1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {});
  EXPECT_TRUE(
      same_surface({Kind::Plane, Transform{}, 0, 0}, {Kind::Plane, flip, 0, 0}, kBox, 1e-12));
  EXPECT_TRUE(same_surface({Kind::Plane, Transform{}, 0, 0},
                           {Kind::Plane, Transform::translation({5, 7, 0}), 0, 0}, kBox, 1e-12));
  EXPECT_TRUE(same_surface({Kind::Cylinder, Transform{}, 3, 0},
                           {Kind::Cylinder, flip * Transform::translation({0, 0, 4}), 3, 0}, kBox,
                           1e-12));
  EXPECT_TRUE(same_surface({Kind::Cone, Transform{}, 3, 0.5},
                           {Kind::Cone, Transform::translation({0, 0, 2}), 4, 0.5}, kBox, 1e-12));
  EXPECT_TRUE(same_surface({Kind::Cone, Transform{}, 3, 0}, {Kind::Cylinder, Transform{}, 3, 0},
                           kBox, 1e-12));
  EXPECT_TRUE(
      same_surface({Kind::Cone, Transform{}, 3, 0.5}, {Kind::Cone, flip, 3, -0.5}, kBox, 1e-12));
}

TEST(SameSurface, FailsWhereOneMovesByMoreThanTheTolerance) {
  for (const auto& [name, surface] : all_kinds()) {
    Surface moved = surface;
    moved.frame = surface.frame * Transform::translation({2e-6, 2e-6, 2e-6});
    EXPECT_FALSE(same_surface(surface, moved, kBox, 1e-6)) << name;
    EXPECT_TRUE(same_surface(surface, moved, kBox, 1e-5)) << name;
    if (surface.kind == Kind::Plane) continue;
    Surface grown = surface;
    grown.r1 += 2e-6;
    EXPECT_FALSE(same_surface(surface, grown, kBox, 1e-6)) << name;
    EXPECT_TRUE(same_surface(surface, grown, kBox, 1e-5)) << name;
  }
  const double a = 1e-6;
  const Transform tilt = Transform::frame({1, 0, 0}, {0, std::cos(a), std::sin(a)},
                                          {0, -std::sin(a), std::cos(a)}, {});
  for (const Kind kind : {Kind::Plane, Kind::Cylinder, Kind::Cone, Kind::Torus}) {
    EXPECT_FALSE(same_surface({kind, Transform{}, 5, 0.5}, {kind, tilt, 5, 0.5}, kBox, 1e-6));
    EXPECT_TRUE(same_surface({kind, Transform{}, 5, 0.5}, {kind, tilt, 5, 0.5}, kBox, 1e-4));
  }
}

TEST(SameSurface, FailsForCylindersThatCrossInABoxThatIsFlatAlongOneOfTheirAxes) {
  const Box flat{{-20, -20, 0}, {20, 20, 0}};
  const Surface upright{Kind::Cylinder, Transform{}, 3, 0};
  const Surface lying{Kind::Cylinder, Transform::frame({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}), 3, 0};
  EXPECT_FALSE(same_surface(upright, lying, flat, 1e-6));
  EXPECT_FALSE(same_surface(lying, upright, flat, 1e-6));
}

TEST(SameSurface, FailsForDifferentKinds) {
  const auto kinds = all_kinds();
  for (const Named& a : kinds)
    for (const Named& b : kinds) {
      if (a.name == b.name) continue;
      EXPECT_FALSE(same_surface(a.surface, b.surface, kBox, 1e-3)) << a.name << " and " << b.name;
    }
}

}  // namespace
}  // namespace remeshd
