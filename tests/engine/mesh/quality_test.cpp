#include "engine/mesh/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/base/random.h"

namespace remeshd {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

const std::array<Vec3, 4> kRegular{Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 1}, Vec3{1, 0, 1}};
const std::array<Vec3, 4> kCorner{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

TEST(VolumeLength, IsOneForARegularTetOfAnySize) {
  for (const double s : {1e-3, 1.0, 250.0})
    EXPECT_NEAR(volume_length(s * kRegular[0], s * kRegular[1], s * kRegular[2], s * kRegular[3]),
                1.0, 1e-14);
}

TEST(VolumeLength, IsThatOfTheFormulaForACornerOfACube) {
  // V = 1/6, edges 1, 1, 1 and three times sqrt 2: l_rms^2 = 9/6.
  const double expected = 6 * std::sqrt(2.0) / 6 / std::pow(1.5, 1.5);
  EXPECT_NEAR(volume_length(kCorner[0], kCorner[1], kCorner[2], kCorner[3]), expected, 1e-15);
}

TEST(VolumeLength, IsNegativeForAnInvertedTetAndZeroForAFlatOrCollapsedOne) {
  EXPECT_NEAR(volume_length(kRegular[1], kRegular[0], kRegular[2], kRegular[3]), -1.0, 1e-14);
  EXPECT_EQ(volume_length({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}), 0.0);
  EXPECT_EQ(volume_length({2, 2, 2}, {2, 2, 2}, {2, 2, 2}, {2, 2, 2}), 0.0);
}

TEST(DihedralAngles, ComeInTheOrderOfTheEdges01_02_03_12_13_23) {
  // Edges at the cube's corner are square; the others lie on the face x + y + z = 1.
  const auto angles = dihedral_angles(kCorner[0], kCorner[1], kCorner[2], kCorner[3]);
  const double oblique = std::acos(1 / std::sqrt(3.0));
  const std::array<double, 6> expected{
      std::numbers::pi / 2, std::numbers::pi / 2, std::numbers::pi / 2, oblique, oblique, oblique};
  for (int e = 0; e < 6; ++e) EXPECT_NEAR(angles[e], expected[e], 1e-14) << "edge " << e;
  // A wedge of 30 degrees at the edge 02 alone.
  const double t = std::numbers::pi / 6;
  const auto wedge =
      dihedral_angles({0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {std::cos(t), std::sin(t), 0});
  EXPECT_NEAR(wedge[1], t, 1e-14);
}

TEST(DihedralAngles, OfASliverKeepTheirDigitsNearZeroAndStraight) {
  // The two diagonals of a unit square, one lifted by h: nearly straight at the diagonals, where a
  // plane through one rises to the height h over half of the other, and nearly 0 at the sides.
  const double h = 1e-9;
  const auto angles = dihedral_angles({0, 0, 0}, {1, 1, 0}, {0, 1, h}, {1, 0, h});
  EXPECT_NEAR(std::numbers::pi - angles[0], 2 * std::atan(h * std::sqrt(2.0)), 1e-15);
  for (const int side : {1, 2, 3, 4}) {
    EXPECT_GT(angles[side], 0.5e-9);
    EXPECT_LT(angles[side], 4e-9);
  }
}

TEST(MeasureQuality, OfAnEmptyMeshIsZeros) {
  const Quality quality = measure_quality({}, {}, {});
  EXPECT_EQ(quality.volume, 0);
  EXPECT_EQ(quality.volume_length_min, 0);
  EXPECT_EQ(quality.dihedral_max, 0);
  EXPECT_EQ(std::accumulate(quality.histogram.begin(), quality.histogram.end(), 0U), 0U);
}

TEST(MeasureQuality, OfACubeOfFiveTetsCountsFourCornersAndARegularTet) {
  const std::vector<Vec3> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const std::vector<Tet> tets{{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};
  const Quality quality = measure_quality(nodes, tets, {});
  const double corner = std::sqrt(2.0) / std::pow(1.5, 1.5);
  EXPECT_NEAR(quality.volume, 1.0, 1e-15);
  EXPECT_NEAR(quality.volume_length_min, corner, 1e-15);
  EXPECT_NEAR(quality.volume_length_p01, corner, 1e-15);
  EXPECT_NEAR(quality.volume_length_mean, (4 * corner + 1) / 5, 1e-7);
  EXPECT_NEAR(quality.dihedral_min, std::acos(1 / std::sqrt(3.0)) * kDegrees, 1e-12);
  EXPECT_NEAR(quality.dihedral_max, 90.0, 1e-12);
  EXPECT_EQ(quality.histogram[15], 4U) << "corner tets measure .77";
  EXPECT_EQ(quality.histogram[19], 1U) << "the regular tet measures 1";
}

TEST(MeasureQuality, FirstPercentileOf200TetsIsTheSecondWorst) {
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
  std::vector<double> measures;
  for (int i = 0; i < 200; ++i) {
    const auto n = static_cast<std::int32_t>(nodes.size());
    const double height = 0.9 - 0.004 * i;
    for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, height}})
      nodes.push_back(p);
    tets.push_back({n, n + 1, n + 2, n + 3});
    measures.push_back(volume_length(nodes[n], nodes[n + 1], nodes[n + 2], nodes[n + 3]));
  }
  std::sort(measures.begin(), measures.end());
  const Quality quality = measure_quality(nodes, tets, {});
  EXPECT_EQ(quality.volume_length_p01, measures[1]);
  EXPECT_EQ(quality.volume_length_min, measures[0]);
}

TEST(MeasureQuality, CountsInvertedTetsInTheFirstBin) {
  const std::vector<Vec3> nodes(kRegular.begin(), kRegular.end());
  const std::vector<Tet> tets{{1, 0, 2, 3}};
  const Quality quality = measure_quality(nodes, tets, {});
  EXPECT_EQ(quality.histogram[0], 1U);
  EXPECT_LT(quality.volume, 0);
}

TEST(SummariseBoth, SaysWhatMeasuringEachMeshSays) {
  Random random(5);
  std::vector<Vec3> nodes;
  for (int n = 0; n < 300; ++n)
    nodes.push_back({random.uniform(), random.uniform(), random.uniform()});
  const auto some_tet = [&] {
    Tet t{};
    do {
      for (std::int32_t& n : t) n = static_cast<std::int32_t>(random.below(nodes.size()));
    } while (tet_volume(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]) < 1e-3);
    return t;
  };
  // The worst ones are left out, come instead, or neither; and nothing changes at all.
  for (const int worst : {0, 1, 2, 3}) {
    std::vector<Tet> first, second, instead;
    std::vector<std::uint8_t> left_out;
    for (int k = 0; k < 2000; ++k) {
      const Tet t = some_tet();
      const bool bad = volume_length(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]) < 0.2;
      if (bad && worst == 1) {
        instead.push_back(t);
        continue;
      }
      first.push_back(t);
      left_out.push_back(worst < 3 && (k % 7 == 0 || (bad && worst == 0)) ? 1 : 0);
      if (left_out.back() == 0) second.push_back(t);
    }
    second.insert(second.end(), instead.begin(), instead.end());
    const CowVector<Vec3> at(nodes);
    const CowVector<Tet> of_first(first), of_instead(instead);
    const CowVector<TetMeasure> measures = measure_tets(at, of_first, {});
    const CowVector<TetMeasure> measures_instead = measure_tets(at, of_instead, {});
    const TwoQualities both = summarise_both({at, of_first, measures, left_out}, 3,
                                             {at, of_instead, measures_instead}, 4);
    const auto expect_same = [](const Quality& a, const Quality& b) {
      EXPECT_NEAR(a.volume_length_mean, b.volume_length_mean, 1e-12);
      EXPECT_EQ(a.volume_length_p01, b.volume_length_p01);
      EXPECT_EQ(a.volume_length_min, b.volume_length_min);
      EXPECT_EQ(a.dihedral_min, b.dihedral_min);
      EXPECT_EQ(a.dihedral_max, b.dihedral_max);
      EXPECT_EQ(a.histogram, b.histogram);
    };
    SCOPED_TRACE(worst);
    expect_same(both.first, measure_quality(nodes, first, {}));
    expect_same(both.second, measure_quality(nodes, second, {}));
    EXPECT_EQ(both.first.volume, 3);
    EXPECT_EQ(both.second.volume, 4);
  }
}

}  // namespace
}  // namespace remeshd
