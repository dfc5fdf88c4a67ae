#include "engine/local_fuse/arrangement/sectors.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::feature;
using test::FuseInput;
using test::model_of;
using test::point;
using test::reason_of;

/// What is seen from a point along a line, after a change to the features' patches.
Tried<std::vector<HalfFace>> around(
    std::vector<FeatureSource> features, const Vec3& p, const Vec3& direction,
    const std::function<void(std::vector<Patch>&)>& change = [](std::vector<Patch>&) {}) {
  const FuseInput in(model_of(std::move(features)));
  Patches patches = *find_patches(in.model, in.membership, in.features);
  change(patches.patches);
  IntersectionCurve line;
  line.origin = p;
  line.direction = direction;
  return Sectors(in.membership, in.features, patches, in.diagonal, in.clearance).around(line, 0);
}

std::vector<Patch>::iterator named(std::vector<Patch>& patches, const std::string& face) {
  return std::ranges::find(patches, face, [](const Patch& patch) { return patch.face->name; });
}

const FeatureSource kCube = block("cube", 10, 10, 10);
/// With an angle of 135 degrees at (10, 0).
const FeatureSource kBeam =
    feature("beam", "prism",
            {point(0., 0.), point(10., 0.), point(15., 5.), point(15., 15.), point(0., 15.)},
            {{"height", 10.0}});
constexpr Vec3 kAlongX{1, 0, 0}, kUp{0, 0, 1};

TEST(SectorsTest, TwoHalfFacesMeetAtAnEdgeOfACube) {
  const auto half_faces = around({kCube}, {0, 5, 10}, kAlongX);
  ASSERT_EQ(reason_of(half_faces), "");
  EXPECT_EQ(half_faces->size(), 2U);
}

TEST(SectorsTest, AFaceNearACurveIsGivenUp) {
  EXPECT_EQ(reason_of(around({kCube}, {0, 5, 10 + 1e-7}, kAlongX)),
            "sectors: a face comes near a curve that it does not clearly contain");
}

TEST(SectorsTest, AFaceAcrossACurveIsGivenUp) {
  EXPECT_EQ(reason_of(around({kCube}, {5, 5, 10}, kAlongX)),
            "sectors: a face crosses a curve where no edge ends");
}

TEST(SectorsTest, AVerySharpEdgeIsGivenUp) {
  const FeatureSource wedge = feature(
      "wedge", "prism", {point(0., 0.), point(10., 0.), point(10., 0.1)}, {{"height", 5.0}});
  EXPECT_EQ(reason_of(around({wedge}, {0, 0, 2}, kUp)),
            "sectors: two faces meet at a curve at a very small angle");
}

TEST(SectorsTest, EachFeatureCoversAHalfFaceOnce) {
  const Vec3 p{10, 0, 5};
  EXPECT_EQ(reason_of(around({kBeam}, p, kUp)), "");
  EXPECT_EQ(reason_of(around({kBeam}, p, kUp,
                             [](auto& patches) {
                               const Patch side = *named(patches, "side1");
                               patches.push_back(side);
                             })),
            "sectors: two faces of one feature cover the same half-face");
  EXPECT_EQ(reason_of(around({kBeam}, p, kUp,
                             [](auto& patches) { patches.erase(named(patches, "side1")); })),
            "sectors: no face of a feature covers a half-face that bounds it");
}

TEST(SectorsTest, APlaneAndACylinderThatTouchAreNotOneFace) {
  EXPECT_EQ(reason_of(around({block("b", 8, 20, 10), cylinder("c", 4, 10)}, {4, 0, 5}, kUp)),
            "sectors: the faces that cover a half-face are not on the same surface");
}

}  // namespace
}  // namespace remeshd
