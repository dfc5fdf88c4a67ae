#include "engine/boundary/lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace remeshd {
namespace {

using Kind = Surface::Kind;

constexpr double kSpacing = 0.5, kJitter = 0.8;

struct Visits {
  std::vector<Vec3> inside;  ///< the points in the box
  std::size_t all = 0;
};

Visits visits(const Surface& surface, const Box& box, const Box& counted) {
  Visits found;
  Random random(5);
  const Box within = grown(box, kSpacing);
  visit_lattice(surface, box, within, kSpacing, kJitter, random, [&](const Vec3& p) {
    ++found.all;
    if (counted.contains(p, kSpacing)) found.inside.push_back(p);
  });
  return found;
}

struct Named {
  std::string name;
  Surface surface;
};

/// Surfaces through the origin, nearly the plane z = 0 there.
std::vector<Named> nearly_flat() {
  const double r = 1e5;
  const Transform below = Transform::translation({0, 0, -r});
  const Transform upright = Transform::frame({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -r});
  return {{"cylinder", {Kind::Cylinder, upright, r, 0}},
          {"cone", {Kind::Cone, Transform::translation({0, 0, -1e-4}), 5, -1e6}},
          {"cone beside its axis", {Kind::Cone, Transform::translation({-r, 0, -1e-3}), r, -1e6}},
          {"sphere", {Kind::Sphere, below, r, 0}},
          {"torus", {Kind::Torus, upright, r / 2, r / 2}},
          {"lying torus", {Kind::Torus, below, 10, r}}};
}

TEST(Lattice, CostsWhatIsInTheBoxHoweverLargeTheRadius) {
  const Box box{{-10, -10, -3}, {10, 10, 4}};
  const double expected = 20 * 20 / (kSpacing * kSpacing);
  for (const auto& [name, surface] : nearly_flat()) {
    const Visits found = visits(surface, box, box);
    EXPECT_NEAR(found.inside.size(), expected, 0.25 * expected) << name;
    EXPECT_LT(found.all, 4 * expected) << name;
    for (const Vec3& p : found.inside) EXPECT_NEAR(signed_distance(surface, p), 0, 1e-9) << name;
  }
}

TEST(Lattice, APartOfTheBoxGetsThePointsOfTheWhole) {
  const Transform tilted = Transform::frame({0.6, 0, 0.8}, {0, 1, 0}, {-0.8, 0, 0.6}, {1, 2, 3});
  // What is 1,000 along its x axis is nearly the plane y = z, which is in all of the patches.
  const double half = std::sqrt(0.5);
  const Transform far = Transform::frame({0, half, -half}, {0, half, half}, {1, 0, 0},
                                         {0, -1000 * half, 1000 * half});
  const std::vector<Named> surfaces{{"sphere", {Kind::Sphere, tilted, 7, 0}},
                                    {"torus", {Kind::Torus, tilted, 6, 2}},
                                    {"apple", {Kind::Torus, tilted, 2, 5}},
                                    // Of so many rows that only some are looked at.
                                    {"large sphere", {Kind::Sphere, far, 1000, 0}},
                                    {"large torus", {Kind::Torus, far, 400, 600}}};
  const Box whole{{-12, -12, -12}, {14, 14, 14}};
  for (const auto& [name, surface] : surfaces)
    for (const Box& patch : {Box{{3, 3, 3}, {14, 14, 14}}, Box{{-12, -12, -12}, {-2, 1, 3}},
                             Box{{0, -12, 5}, {4, 14, 14}}}) {
      const Visits of_whole = visits(surface, whole, patch),
                   of_patch = visits(surface, patch, patch);
      EXPECT_EQ(of_patch.inside, of_whole.inside) << name;
      EXPECT_LE(of_patch.all, of_whole.all) << name;
      EXPECT_FALSE(of_patch.inside.empty()) << name;
    }
  // The rows of a cylinder begin where the box does.
  const Surface cylinder{Kind::Cylinder, Transform::translation({1, 2, 0}), 7, 0};
  const Box side{{3, -9, -2}, {9, 4, 5}};
  EXPECT_EQ(visits(cylinder, side, side).inside,
            visits(cylinder, {{-9, -9, -2}, {9, 9, 5}}, side).inside);
  EXPECT_FALSE(visits(cylinder, side, side).inside.empty());
  EXPECT_EQ(visits(cylinder, {{0, 1, -2}, {2, 3, 5}}, side).all, 0U) << "nothing near its axis";
}

TEST(Lattice, HasAPointForEachSquareOfTheSpacingOnAWholeTorus) {
  constexpr double kMajor = 6, kMinor = 2;
  const Box whole{{-8, -8, -2}, {8, 8, 2}};
  const Visits found = visits({Kind::Torus, Transform{}, kMajor, kMinor}, whole, whole);
  const double area = 4 * std::numbers::pi * std::numbers::pi * kMajor * kMinor;
  const double expected = area / (kSpacing * kSpacing);  // in 25 rows
  EXPECT_NEAR(found.inside.size(), expected, 0.01 * expected);
}

TEST(Lattice, AConeEndsAtItsApex) {
  const Surface cone{Kind::Cone, Transform::translation({0, 0, 0}), 4, -1};
  const Box box{{-10, -10, 0}, {10, 10, 10}};
  const Visits found = visits(cone, box, box);
  EXPECT_FALSE(found.inside.empty());
  for (const Vec3& p : found.inside) EXPECT_LE(p.z, 4);
}

}  // namespace
}  // namespace remeshd
