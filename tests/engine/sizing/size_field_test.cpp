#include "engine/sizing/size_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random.h"

namespace remeshd {
namespace {

const Box kBounds{{-50, -50, -50}, {50, 50, 50}};
constexpr SizeLimits kTen{.base = 10, .least = 1, .slope = 0.3};

/// A round wall about the z axis from z = 0 to `height`.
SizeSource pin(double radius, double height, double size, const Vec3& at = {}) {
  Surface surface{Surface::Kind::Cylinder, Transform::translation(at), radius, 0};
  const Vec3 r{radius, radius, 0};
  return {surface, {at - r, at + r + Vec3{0, 0, height}}, size};
}

/// Many small pins on a plate.
std::vector<SizeSource> many() {
  std::vector<SizeSource> sources;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y) sources.push_back(pin(1.5, 5, 2, {10.0 * x, 10.0 * y, 0}));
  return sources;
}

Vec3 any_point(Random& random) {
  return {random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60)};
}

TEST(SizeField, IsEvenWithoutSources) {
  const SizeField even = 3;
  EXPECT_TRUE(even.even());
  EXPECT_EQ(even({1, 2, 3}), 3);
  EXPECT_EQ(even.least(), 3);
  EXPECT_EQ(even.grid_length(), 3);
  EXPECT_TRUE(SizeField(kTen, {}, kBounds).even());
  EXPECT_TRUE(SizeField(kTen, {pin(20, 5, 10)}, kBounds).even());
}

TEST(SizeField, IsTheSizeAskedForThereAndGrowsAwayFromIt) {
  const SizeField field(kTen, {pin(4, 5, 2)}, kBounds);
  EXPECT_FALSE(field.even());
  EXPECT_DOUBLE_EQ(field({4, 0, 2}), 2);
  EXPECT_DOUBLE_EQ(field({14, 0, 2}), 5);
  EXPECT_DOUBLE_EQ(field({4, 0, 15}), 5);  // beyond the end of the wall
  EXPECT_DOUBLE_EQ(field({0, 0, 2}), 2 + 0.3 * 4);
  EXPECT_EQ(field({45, 0, 2}), 10);
  EXPECT_EQ(field.least(), 2);
}

TEST(SizeField, AsksForNoLessThanTheLeast) {
  const SizeField field(kTen, {pin(0.1, 5, 0.05)}, kBounds);
  EXPECT_EQ(field({0.1, 0, 2}), 1);
  EXPECT_EQ(field.least(), 1);
}

TEST(SizeField, GrowsAwayFromATriangle) {
  const std::array<Vec3, 3> triangle{Vec3{0, 0, 0}, Vec3{9, 0, 0}, Vec3{0, 9, 0}};
  const SizeField field(kTen, {{triangle, box_of(triangle), 2}}, kBounds);
  EXPECT_DOUBLE_EQ(field({2, 2, 0}), 2);
  EXPECT_DOUBLE_EQ(field({2, 2, 10}), 5);
  EXPECT_DOUBLE_EQ(field({-10, 0, 0}), 5);
  EXPECT_EQ(field.least(), 2);
}

TEST(SizeField, TellsWhatAllSourcesTell) {
  std::vector<SizeSource> sources = many();
  for (int k = 0; k < 9; ++k) {
    const Vec3 at{3.0 * k, 20 - 4.0 * k, 5};
    const std::array<Vec3, 3> triangle{at, at + Vec3{1, 0, 2}, at + Vec3{0, 2, 1}};
    sources.push_back({triangle, box_of(triangle), 1.0 + 0.1 * k});
  }
  const SizeField field(kTen, sources, kBounds);
  Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = any_point(random);
    double least = 10;
    for (const SizeSource& s : sources) least = std::fmin(least, s.at(p, kTen));
    ASSERT_EQ(field(p), least) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(SizeField, TellsLengthsThatItIsBelowAndOneThatItDoesNotExceed) {
  const SizeField field(kTen, many(), kBounds);
  const SizeField even = 10;
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 p = any_point(random);
    const double length = field(p);
    EXPECT_FALSE(field.is_below(p, 0.999 * length));
    EXPECT_TRUE(field.is_below(p, 1.001 * length));
    EXPECT_GE(field.bound(p), length);
    EXPECT_LE(field.bound(p), field.base());
    EXPECT_DOUBLE_EQ(field.asked_for(p, 4), std::fmin(field.asked_for(p), 4));
    EXPECT_FALSE(even.is_below(p, 10));
    EXPECT_TRUE(even.is_below(p, 10.1));
    EXPECT_EQ(even.bound(p), 10);
  }
}

TEST(SizeField, TellsWhereTheModelAsksForTheLeast) {
  SizeSource asked = pin(4, 5, 3, {30, 0, 0});
  asked.asked = true;
  const SizeField field(kTen, {pin(4, 5, 2), asked}, kBounds);
  EXPECT_FALSE(field.is_asked_below({4, 0, 2}, 9));
  EXPECT_TRUE(field.is_asked_below({34, 0, 2}, 3.1));
  EXPECT_FALSE(field.is_asked_below({34, 0, 2}, 2.9));
  EXPECT_FALSE(field.is_asked_below({-45, 0, 2}, 10));
  EXPECT_FALSE(SizeField(10).is_asked_below({}, 11));
}

TEST(SizeField, GrowsNoFasterThanAllowed) {
  const SizeField field(kTen, many(), kBounds);
  Random random(2);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = any_point(random);
    const Vec3 q = p + 0.1 * any_point(random);
    ASSERT_LE(std::fabs(field(p) - field(q)), 0.3 * distance(p, q) + 1e-9);
  }
}

TEST(SizeField, OnAConeTheSizeFollowsItsCircles) {
  const Surface cone{Surface::Kind::Cone, {}, 10, -0.5};
  const SizeField field(kTen, {{cone, {{-10, -10, 0}, {10, 10, 16}}, 0.5}}, kBounds);
  const double steeper = std::sqrt(1.25);  // its radius of curvature by that of a circle
  EXPECT_NEAR(field({10, 0, 0}), 5 * steeper, 1e-9);
  EXPECT_NEAR(field({6, 0, 8}), 3 * steeper, 1e-9);
  EXPECT_NEAR(field({2, 0, 16}), 1 * steeper, 1e-9);
  EXPECT_EQ(field.least(), 1);
}

TEST(SizeField, RefinedIsFinerRoundSomePlacesAlone) {
  const std::vector<Vec3> places{{0, 0, 0}};
  const SizeField was(kTen, {pin(0.1, 5, 0.05, {30, 0, 0})}, kBounds);
  const SizeField field = was.refined(places, 0.5, kBounds);
  EXPECT_DOUBLE_EQ(field({0, 0, 0}), 0.5 * was({0, 0, 0}));
  EXPECT_EQ(field({30.1, 0, 2}), was({30.1, 0, 2})) << "what the least size limits stays so";
  EXPECT_EQ(field({-40, 0, 0}), was({-40, 0, 0}));
  const SizeField even = SizeField(8).refined(places, 0.5, kBounds);
  EXPECT_EQ(even({0, 0, 0}), 4);
  EXPECT_EQ(even({45, 0, 0}), 8);
}

TEST(SizeField, ARangeHoldsWhatABoxHas) {
  const SizeField field(kTen, many(), kBounds);
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Vec3 corner = any_point(random);
    const Box box{corner, corner + Vec3{random.uniform(0, 9), random.uniform(0, 9), 4}};
    const SizeField::Range range = field.in(box);
    for (const Vec3& p : corners_of(box)) {
      ASSERT_GE(field(p), range.least);
      ASSERT_LE(field(p), range.greatest);
    }
  }
}

TEST(SizeField, EvenPartsCoverASurfaceOnce) {
  const SizeField field(kTen, many(), kBounds);
  const Vec3 middle = 0.5 * (kBounds.lo + kBounds.hi);
  Surface ball{Surface::Kind::Sphere, Transform::frame({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, middle)};
  ball.r1 = 0.3 * (kBounds.hi.x - kBounds.lo.x);
  const auto parts = field.even_parts(kBounds, ball);
  EXPECT_GT(parts.size(), 10U);
  Random random(4);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = project(ball, any_point(random));
    int holding = 0;
    for (const auto& part : parts) {
      if (!part.holds(p)) continue;
      ++holding;
      if (kBounds.contains(p)) {
        ASSERT_LT(std::fabs(part.length / field(p) - 1), 0.5);
      }
    }
    ASSERT_EQ(holding, 1);
  }
  ball.r1 = 1;  // far less to cover
  EXPECT_LT(field.even_parts(kBounds, ball).size(), parts.size());
  EXPECT_EQ(SizeField(3).even_parts(kBounds, ball).size(), 1U);
}

}  // namespace
}  // namespace remeshd
