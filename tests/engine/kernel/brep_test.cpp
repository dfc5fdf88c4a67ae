#include "engine/kernel/brep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/kernel/primitives.h"
#include "tests/support/run.h"

namespace remeshd::kernel {
namespace {

using std::numbers::pi;

using test::kRun;

Brep square(double side, double height, double scale) {
  const auto to = [](std::array<double, 2> a, std::array<double, 2> b) {
    return ProfileCurve{.from = a, .to = b, .label = "side"};
  };
  const double s = side;
  return make_prism(
      std::array{to({0, 0}, {s, 0}), to({s, 0}, {s, s}), to({s, s}, {0, s}), to({0, s}, {0, 0})},
      height, scale);
}

double volume_with(const Fusion& fusion, const std::vector<int>& parts) {
  double volume = 0;
  for (std::size_t c = 0; c < fusion.cells.size(); ++c) {
    std::vector<int> of;
    for (const Source& source : fusion.cells[c]) of.push_back(source.part);
    if (of == parts) volume += fusion.brep.cells[c].volume;
  }
  return volume;
}

TEST(BrepTest, AFuseKeepsEveryRegionAndTellsWhoCoversIt) {
  const Brep a = square(10, 10, 8);
  const std::array parts{Part{&a, {0}, {}}, Part{&a, {0}, Transform::translation({5, 0, 0})}};
  const Fusion fusion = general_fuse(parts, kRun);
  EXPECT_EQ(fusion.brep.cells.size(), 3u);
  EXPECT_NEAR(volume_with(fusion, {0}), 500, 1e-9);
  EXPECT_NEAR(volume_with(fusion, {1}), 500, 1e-9);
  EXPECT_NEAR(volume_with(fusion, {0, 1}), 500, 1e-9);
}

TEST(BrepTest, FacesThatCoincideAreOneFaceOfBoth) {
  const Brep a = square(10, 10, 8);
  const std::array parts{Part{&a, {0}, {}}, Part{&a, {0}, Transform::translation({10, 0, 0})}};
  const Fusion fusion = general_fuse(parts, kRun);
  EXPECT_EQ(fusion.brep.faces.size(), 11u);
  int shared = 0;
  for (std::size_t f = 0; f < fusion.faces.size(); ++f)
    if (fusion.faces[f].size() == 2) {
      ++shared;
      EXPECT_GE(fusion.brep.faces[f].cells[0], 0);
      EXPECT_GE(fusion.brep.faces[f].cells[1], 0);
    }
  EXPECT_EQ(shared, 1);
}

TEST(BrepTest, WhatOnlyOneSideHasIsItsOwnAndCrossingsAreNobodys) {
  // Two bars crossing: four of the edges where faces cross lie on no edge of either.
  const Brep a = square(10, 4, 8);
  const Transform turned = Transform::frame({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {3, 3, -3});
  const std::array parts{Part{&a, {0}, {}}, Part{&a, {0}, turned}};
  const Fusion fusion = general_fuse(parts, kRun);
  int nobodys = 0;
  for (const auto& sources : fusion.edges) nobodys += sources.empty();
  EXPECT_GT(nobodys, 0);
  for (const auto& sources : fusion.faces) EXPECT_FALSE(sources.empty());
  for (const auto& sources : fusion.cells) EXPECT_FALSE(sources.empty());
}

TEST(BrepTest, ASinglePartIsReadAsItIs) {
  const Brep a = make_cone(5, 5, 10, 8);
  EXPECT_NO_THROW(make_cone(5, 5 + 1e-10, 10, 8)) << "OCCT refuses them as equal";
  const Fusion fusion = general_fuse(std::array{Part{&a, {0}, {}}}, kRun);
  ASSERT_EQ(fusion.brep.cells.size(), 1u);
  EXPECT_NEAR(fusion.brep.cells[0].volume, 250 * pi, 1e-9);
  EXPECT_EQ(fusion.faces.size(), 3u);
  for (const auto& sources : fusion.faces) EXPECT_EQ(sources.size(), 1u);
}

TEST(BrepTest, APartIsSomeCellsOfAFuseAndMayBeFusedAgain) {
  const Brep a = square(10, 10, 8);
  const std::array parts{Part{&a, {0}, {}}, Part{&a, {0}, Transform::translation({5, 0, 0})}};
  const Fusion first = general_fuse(parts, kRun);
  std::vector<int> of_first;
  for (int c = 0; c < 3; ++c)
    if (first.cells[c].front().part == 0) of_first.push_back(c);
  ASSERT_EQ(of_first.size(), 2u);
  const std::array again{Part{&first.brep, of_first, {}},
                         Part{&first.brep, of_first, Transform::translation({0, 0, 4})}};
  const Fusion second = general_fuse(again, kRun);
  EXPECT_EQ(second.brep.cells.size(), 6u);
  EXPECT_NEAR(volume_with(second, {0, 1}), 600, 1e-9);
}

TEST(BrepTest, EdgesLongerThanTheShortestAreMade) {
  const double shortest = shortest_edge(8);
  EXPECT_NO_THROW(square(1.01 * shortest, 1, 8));
  EXPECT_THROW(square(0.99 * shortest, 1, 8), remeshd::Error);
}

TEST(BrepTest, FusingLeavesItsPartsAsTheyWere) {
  const Brep a = square(10, 10, 8);
  const std::array parts{Part{&a, {0}, {}}, Part{&a, {0}, Transform::translation({5, 0, 0})}};
  const Fusion once = general_fuse(parts, kRun), twice = general_fuse(parts, kRun);
  EXPECT_EQ(once.brep.points, twice.brep.points);
}

TEST(BrepTest, VolumesBehindCurvesOfIntersectionAreExact) {
  // A thin cylinder straight through a thick one; the gauss rule alone errs by 3e-6.
  const double scale = unit_scale(22);
  const Brep thick = make_cone(5, 5, 20, scale), thin = make_cone(3, 3, 20, scale);
  const Transform across = Transform::frame({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {-10, 0, 10});
  const Fusion fusion =
      general_fuse(std::array{Part{&thick, {0}, {}}, Part{&thin, {0}, across}}, kRun);
  EXPECT_NEAR(volume_with(fusion, {0}) + volume_with(fusion, {0, 1}), 500 * pi, 1e-8);
  EXPECT_NEAR(volume_with(fusion, {1}) + volume_with(fusion, {0, 1}), 180 * pi, 1e-8);
}

TEST(BrepTest, ARingThatIsNarrowerThanItsChordsStandOffIsTriangulated) {
  // Of two cylinders on one axis, as a small change of a radius leaves them: halving rims until
  // their chords are clear of each other takes thousands of nodes.
  const double scale = unit_scale(22), radius = 1.3345446984408427;
  const Brep below = make_cone(radius + 4.66912e-8, radius + 4.66912e-8, 1.85, scale);
  const Brep above = make_cone(radius, radius, 1.85, scale);
  for (const double turn : {0.0, 0.05}) {
    const Transform on_top =
        Transform::frame({std::cos(turn), std::sin(turn), 0}, {-std::sin(turn), std::cos(turn), 0},
                         {0, 0, 1}, {0, 0, 1.85});
    const Fusion fusion =
        general_fuse(std::array{Part{&below, {0}, {}}, Part{&above, {0}, on_top}}, kRun);
    EXPECT_EQ(fusion.brep.cells.size(), 2u);
    EXPECT_LT(fusion.brep.points.size(), 1000u) << turn;
  }
}

TEST(BrepTest, ScaleIsAPowerOfTwoThatBringsADiagonalTo128To256) {
  for (const double diagonal : {1e-6, 0.3, 1.0, 127.9, 128.0, 146.0, 1e7}) {
    const double scale = unit_scale(diagonal);
    EXPECT_EQ(std::exp2(std::round(std::log2(scale))), scale);
    EXPECT_GE(diagonal * scale, 128);
    EXPECT_LT(diagonal * scale, 256);
  }
}

}  // namespace
}  // namespace remeshd::kernel
