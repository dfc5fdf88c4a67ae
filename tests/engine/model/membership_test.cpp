#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/base/random.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"

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
