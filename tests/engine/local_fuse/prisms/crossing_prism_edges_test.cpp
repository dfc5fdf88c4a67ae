#include "engine/local_fuse/prisms/crossing_prism_edges.h"

#include <gtest/gtest.h>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using test::block;
using test::feature;
using test::FuseInput;
using test::model_of;
using test::point;
using test::reason_of;

Tried<PrismEdges> edges_of(std::vector<FeatureSource> features) {
  const FuseInput in(model_of(std::move(features)));
  const auto patches = find_patches(in.model, in.membership, in.features);
  if (!patches) return patches.why();
  const auto curves = find_intersection_curves(*patches, in.clearance);
  if (!curves) return curves.why();
  const Sectors sectors(in.membership, in.features, *patches, in.diagonal, in.clearance);
  return find_prism_edges(*curves, sectors, in.clearance);
}

FeatureSource prism(std::vector<ProfileEntry> profile) {
  return feature("prism", "prism", std::move(profile), {{"height", 5.0}});
}

TEST(PrismEdgesTest, ABlockHasTwelveEdges) {
  const auto edges = edges_of({block("b", 10, 10, 10)});
  ASSERT_EQ(reason_of(edges), "");
  EXPECT_EQ(edges->edges.size(), 12U);
  EXPECT_EQ(edges->nodes.size(), 8U);
}

TEST(PrismEdgesTest, AnEdgeThatAPlaneMeetsBesideItsFaceStaysOne) {
  // The post stands beside the triangle's long side, in the box round it.
  const auto edges = edges_of({prism({point(0., 0.), point(10., 0.), point(0., 10.)}),
                               test::placed(block("post", 1, 1, 10), 8, 8, 0)});
  ASSERT_EQ(reason_of(edges), "");
  EXPECT_EQ(edges->edges.size(), 9U + 12U);
}

TEST(PrismEdgesTest, NodesThatNearlyCoincideAreGivenUp) {
  EXPECT_EQ(reason_of(edges_of({block("foil", 10, 10, 1e-4)})),
            "crossing_prism_edges: two nodes are neither clearly the same nor clearly apart");
}

TEST(PrismEdgesTest, AVeryShortEdgeIsGivenUp) {
  EXPECT_EQ(reason_of(edges_of(
                {prism({point(0., 0.), point(1e-4, 0.), point(10., 10.), point(0., 10.)})})),
            "crossing_prism_edges: an edge is very short");
}

TEST(PrismEdgesTest, DoubtAboutWhatLiesRoundACurveIsPassedOn) {
  EXPECT_EQ(reason_of(edges_of({prism({point(0., 0.), point(10., 0.), point(10., 0.1)})})),
            "sectors: two faces meet at a curve at a very small angle");
}

}  // namespace
}  // namespace remeshd
