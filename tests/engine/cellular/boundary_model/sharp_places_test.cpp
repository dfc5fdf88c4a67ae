#include "engine/cellular/boundary_model/sharp_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
constexpr double kDegree = std::numbers::pi / 180;

SharpPlaces of(const ModelSource& source) {
  const FeatureModel model = evaluate(source);
  return sharp_places(build_cells(model, kRun).boundary, Membership(model), 25 * kDegree);
}

std::ptrdiff_t count(const std::vector<std::uint8_t>& flags) {
  return std::count(flags.begin(), flags.end(), 1);
}

/// A right-angled prism whose sharp corner has tan(angle) = rise / 40.
ModelSource wedge(double rise) {
  return test::one_feature(test::feature(
      "wedge", "prism", {test::point(0.0, 0.0), test::point(40.0, 0.0), test::point(40.0, rise)},
      {{"height", 20.0}}));
}

TEST(SharpPlaces, AreTheEdgeOfAWedgeAndItsEnds) {
  const SharpPlaces sharp = of(wedge(7));  // 9.9 degrees
  EXPECT_EQ(count(sharp.edges), 1);
  EXPECT_EQ(count(sharp.vertices), 2);
}

TEST(SharpPlaces, AreNotThereFrom25DegreesOn) {
  EXPECT_TRUE(of(wedge(18.2)).any());   // 24.5 degrees
  EXPECT_FALSE(of(wedge(19.1)).any());  // 25.5 degrees
}

TEST(SharpPlaces, AreNotTheGroundOfASlit) {
  ModelSource source = test::one_feature(
      test::feature("block", "block", {{"dx", 60.0}, {"dy", 60.0}, {"dz", 20.0}}));
  FeatureSource slit = test::feature(
      "slit", "prism", {test::point(0.0, 0.0), test::point(40.0, -3.0), test::point(40.0, 3.0)},
      {{"height", 20.0}});
  slit.nature = Nature::Subtractive;
  source.features.push_back(slit);
  const SharpPlaces sharp = of(source);
  EXPECT_EQ(count(sharp.edges), 0);
  // On top and bottom the slit's edges meet at 8.6 degrees, on the side of the void or not.
  EXPECT_EQ(count(sharp.vertices), 2);
}

/// Half of a column, cut off by a plane at 66 degrees: the edge of the cut has a sharp end, of 24
/// degrees, and a blunt one. `upper`: what stays, its sharp end below, or the lower part.
ModelSource cut_column(bool upper) {
  ModelSource source = test::model_of({test::cylinder("column", 10, 80)});
  const double rise = 11 * std::tan(66 * kDegree), end = upper ? -10 : 90;
  const FeatureSource rest =
      test::feature("rest", "prism",
                    {test::point(-11.0, 40 + rise), test::point(11.0, 40 - rise),
                     test::point(11.0, end), test::point(-11.0, end)},
                    {{"height", 24.0}});
  source.features.push_back(
      test::placed(test::turned(rest, {0, -1, 0}, {1, 0, 0}), 0, 12, 0, Nature::Subtractive));
  source.features.push_back(
      test::placed(test::block("half", 30, 20, 90), 0, 10, 0, Nature::Subtractive));
  return source;
}

TEST(SharpPlaces, AreEdgesThatAreSharpAtOneEndWhicheverItIs) {
  for (const bool upper : {false, true}) EXPECT_EQ(count(of(cut_column(upper)).edges), 1) << upper;
}

TEST(SharpPlaces, AreWhereEdgesOfAFaceTouch) {
  // A boss on a disc that touches its rim from inside leaves a crescent with a cusp of no angle.
  ModelSource source =
      test::one_feature(test::feature("disc", "cylinder", {{"radius", 20.0}, {"height", 10.0}}));
  FeatureSource boss = test::feature("boss", "cylinder", {{"radius", 10.0}, {"height", 20.0}});
  boss.placement.origin = {10.0, 0.0, 0.0};
  source.features.push_back(boss);
  EXPECT_EQ(count(of(source).vertices), 1);
  EXPECT_EQ(count(of(source).edges), 0);
  EXPECT_FALSE(of(test::case_model("simple-a")).any());
}

// A pocket's floor of 0.01 in a plate of 4.
TEST(ThinWalls, HoldTetsAcrossThem) {
  const FeatureModel model = evaluate(test::model_of(
      {test::block("plate", 12, 12, 4),
       test::placed(test::cylinder("pocket", 2, 4), 0, 0, 0.01, Nature::Subtractive)}));
  const BoundaryModel boundary = build_cells(model, kRun).boundary;
  const auto on = [&](double z, double radius) {
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
      const BoundaryFace& face = boundary.faces[f];
      if (face.surface.kind == Surface::Kind::Plane &&
          std::fabs(signed_distance(face.surface, {0, 0, z})) < 1e-9 &&
          (face.edges.size() == 1) == (radius < 2.5))
        return Support{Support::Kind::Face, static_cast<std::int32_t>(f)};
    }
    return Support{};
  };
  const Support floor = on(0.01, 2), bottom = on(0, 6), inside;
  ASSERT_EQ(floor.kind, Support::Kind::Face);
  ASSERT_EQ(bottom.kind, Support::Kind::Face);
  const std::array<Vec3, 4> across{Vec3{0, 0, 0.01}, Vec3{1, 0, 0.01}, Vec3{0, 1, 0.01},
                                   Vec3{0, 0, 0}};
  const std::array<Support, 4> at{floor, floor, floor, bottom};
  EXPECT_TRUE(ThinWalls(boundary, 0.1).holds(at, across));
  EXPECT_FALSE(ThinWalls(boundary, 0.005).holds(at, across));
  // A flat tet at the floor is the mesh's fault, not the model's.
  EXPECT_FALSE(
      ThinWalls(boundary, 0.1)
          .holds({floor, floor, floor, inside}, {across[0], across[1], across[2], {0, 0, 0.005}}));
}

}  // namespace
}  // namespace remeshd
