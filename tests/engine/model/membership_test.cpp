#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "engine/base/random.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/random_frame.h"

namespace remeshd {
namespace {

struct Estimate {
  double volume, deviation;
};

Estimate monte_carlo_volume(const Membership& membership) {
  constexpr int kPoints = 200000;
  Random random(41);
  const Box& box = membership.bounds();
  const Vec3 size = box.hi - box.lo;
  const double whole = size.x * size.y * size.z;
  int inside = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double x = random.uniform(box.lo.x, box.hi.x), y = random.uniform(box.lo.y, box.hi.y);
    inside += membership.inside({x, y, random.uniform(box.lo.z, box.hi.z)});
  }
  const double share = static_cast<double>(inside) / kPoints;
  return {whole * share, whole * std::sqrt(share * (1 - share) / kPoints)};
}

TEST(Membership, TheCasesHaveTheirExactVolumes) {
  for (const test::EditCase& c : test::seven_cases()) {
    const Estimate before = monte_carlo_volume(Membership(test::case_features(c.original)));
    EXPECT_NEAR(before.volume, c.original_volume, 4 * before.deviation) << c.original;
    const Estimate after = monte_carlo_volume(Membership(test::case_features(c.modified)));
    EXPECT_NEAR(after.volume, c.modified_volume, 4 * after.deviation) << c.modified;
  }
}

TEST(Membership, TheLastOwnerInHistoryDecides) {
  // tool2: pipe_inner (7) drills pipe_outer (6), which stands on base (0).
  const Membership m(test::case_features("tool2-a"));
  EXPECT_EQ(m.last_owner({15, 0, 30}), 7);
  EXPECT_FALSE(m.inside({15, 0, 30}));
  EXPECT_EQ(m.last_owner({28, 0, 30}), 6);
  EXPECT_TRUE(m.inside({28, 0, 30}));
  EXPECT_EQ(m.last_owner({28, 0, 6}), 0);
  EXPECT_EQ(m.last_owner({200, 0, 6}), -1);
  EXPECT_FALSE(m.inside({200, 0, 6}));
}

TEST(Membership, MaterialAddedLaterFillsAnEarlierHole) {
  // tool2-d: the stiffener (8) comes after the pipe's bore (7) and closes part of it.
  const Membership m(test::case_features("tool2-d"));
  const Vec3 toe{-8.5, 0, 12.1};
  EXPECT_EQ(m.last_owner(toe), 8);
  EXPECT_TRUE(m.inside(toe));
}

TEST(Membership, OwnersComeInHistoryOrder) {
  const Membership m(test::case_features("fig5"));
  std::vector<int> owners{99};
  m.owners({-15, 0, 17}, owners);
  EXPECT_EQ(owners, (std::vector<int>{99, 0, 1, 2}));
  owners.clear();
  m.owners({-15, 10, 17}, owners);
  EXPECT_EQ(owners, (std::vector<int>{0, 1}));
  owners.clear();
  m.owners({0, 0, -1}, owners);
  EXPECT_TRUE(owners.empty());
}

TEST(Membership, CellsOfFigure5HaveTheirVolumes) {
  // Owners as a bit mask; lattice points in the middle of 1 mm cubes measure exactly.
  const Membership m(test::case_features("fig5"));
  std::map<int, int> volume;
  std::vector<int> owners;
  for (int x = -40; x < 40; ++x)
    for (int y = -20; y < 20; ++y)
      for (int z = 0; z < 20; ++z) {
        owners.clear();
        m.owners({x + 0.5, y + 0.5, z + 0.5}, owners);
        int mask = 0;
        for (const int owner : owners) mask |= 1 << owner;
        ++volume[mask];
      }
  EXPECT_EQ(volume, (std::map<int, int>{
                        {0b001, 51680}, {0b011, 6560}, {0b111, 1440}, {0b101, 1080 + 3240}}));
}

/// Rotated boxes of all sizes, every third one subtractive.
FeatureModel clutter(int count, double largest) {
  Random random(43);
  FeatureModel model;
  for (int k = 0; k < count; ++k) {
    Feature f;
    f.id = "f" + std::to_string(k);
    f.nature = k % 3 == 2 ? Nature::Subtractive : Nature::Additive;
    const double size = random.uniform(0.1, largest);
    f.shape = Block{size, 0.5 * size, 2 * size};
    f.placement = test::random_frame(random);
    model.features.push_back(f);
  }
  return model;
}

TEST(Membership, AgreesWithAskingEveryFeature) {
  for (const auto& [count, largest] :
       std::vector<std::pair<int, double>>{{1, 9}, {40, 5}, {500, 2}, {500, 60}}) {
    const Membership m(clutter(count, largest));
    Random random(47);
    int inside = 0;
    for (int k = 0; k < 5000; ++k) {
      const Vec3 p = test::random_point(random, 20);
      std::vector<int> expected, found;
      for (int f = 0; f < count; ++f)
        if (m.solids()[f].contains(p)) expected.push_back(f);
      m.owners(p, found);
      EXPECT_EQ(found, expected);
      EXPECT_EQ(m.last_owner(p), expected.empty() ? -1 : expected.back());
      EXPECT_EQ(m.inside(p), !expected.empty() && expected.back() % 3 != 2);
      inside += m.inside(p);
    }
    EXPECT_GT(inside, 0);
  }
}

TEST(Membership, TakesBoxesThatRoundingFlattens) {
  FeatureSource speck = test::feature("speck", "sphere", {{"radius", 1e-9}});
  speck.placement.origin = {1e9, 1e9, 1e9};
  const Membership m(evaluate(test::one_feature(speck)));
  EXPECT_TRUE(m.inside({1e9, 1e9, 1e9}));
  EXPECT_FALSE(m.inside({0, 0, 0}));
}

TEST(Membership, BoundsAreThoseOfAdditiveFeatures) {
  ModelSource source = test::case_model("simple-a");
  FeatureSource hole = test::feature("hole", "sphere", {{"radius", 500.0}});
  hole.nature = Nature::Subtractive;
  source.features.insert(source.features.begin(), hole);
  const Membership m(evaluate(source));
  EXPECT_EQ(m.bounds().lo, (Vec3{-50, -30, 0}));
  EXPECT_EQ(m.bounds().hi, (Vec3{50, 30, 60}));
  EXPECT_EQ(m.nature(0), Nature::Subtractive);
  EXPECT_TRUE(m.contains(0, {0, 0, 100}));
  EXPECT_FALSE(m.contains(1, {0, 0, 100}));
  EXPECT_EQ(m.solids().size(), 3U);
}

}  // namespace
}  // namespace remeshd
