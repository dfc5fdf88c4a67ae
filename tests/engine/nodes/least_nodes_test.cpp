#include "engine/nodes/least_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/density.h"
#include "engine/remesh/node_limit.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

using test::block;
using test::model_of;
using test::placed;

LeastNodes least(const std::vector<FeatureSource>& features, double edge_length, double limit) {
  return least_nodes(evaluate(model_of(features)), edge_length, limit);
}

TEST(LeastNodes, OfWhatFitsForCertainNothingIsSaid) {
  EXPECT_EQ(least({block("plate", 80, 40, 10)}, 2.5, 10000).nodes, 0);
}

TEST(LeastNodes, OfOneFeatureAreThoseOfItsVolume) {
  const LeastNodes nodes = least({block("plate", 1e9, 40, 10)}, 2.5, 5e6);
  EXPECT_EQ(nodes.feature, "plate");
  EXPECT_GE(nodes.nodes, expected_nodes(4e11, 0, 2.5));
  EXPECT_LE(nodes.nodes, expected_nodes(4e11, 2 * (40e9 + 10e9 + 400), 2.5));
}

TEST(LeastNodes, OfAPlateWithoutThicknessAreThoseOfItsArea) {
  const LeastNodes nodes = least({block("plate", 1e6, 1e6, 1e-6)}, 2.5, 5e6);
  EXPECT_EQ(nodes.feature, "plate");
  EXPECT_NEAR(nodes.nodes, expected_nodes(1e6, 2e12, 2.5), 1e-9 * nodes.nodes);
}

TEST(LeastNodes, OfABarWithoutSectionAreThoseOfItsLength) {
  const LeastNodes nodes = least({block("bar", 1e9, 1e-6, 1e-6)}, 2.5, 5e6);
  EXPECT_EQ(nodes.feature, "bar");
  EXPECT_NEAR(nodes.nodes, 1e9 / 2.5, 1);
}

TEST(LeastNodes, DoNotCountWhatALaterFeatureMayCutAway) {
  const FeatureSource stock = block("stock", 1000, 1000, 1000);
  const FeatureSource cut = placed(block("cut", 1000, 1000, 900), 0, 0, 100, Nature::Subtractive);
  const double left = least({stock, cut}, 1, 1e6).nodes;
  EXPECT_NEAR(left, expected_nodes(1e8, 2e8 / 1000, 1), 1e-6 * left);
  EXPECT_EQ(
      least({stock, placed(block("cut", 2000, 2000, 2000), 0, 0, 0, Nature::Subtractive)}, 1, 1e6)
          .nodes,
      0);
  // What stands before it cuts nothing.
  EXPECT_GE(least({block("base", 1, 1, 1), cut, stock}, 1, 1e6).nodes, expected_nodes(1e9, 0, 1));
}

TEST(LeastNodes, OfManyFeaturesAreThoseOfAllTogether) {
  std::vector<FeatureSource> features;
  for (int k = 0; k < 10000; ++k)
    features.push_back(placed(block("f" + std::to_string(k), 1.1, 1.1, 1), k % 100, k / 100, 0));
  const LeastNodes nodes = least(features, 0.1, 5e6);
  EXPECT_EQ(nodes.feature, "");
  EXPECT_GT(nodes.nodes, 5e6);
  EXPECT_LT(nodes.nodes, expected_nodes(100.1 * 100.1, 0, 0.1));
  EXPECT_EQ(least(features, 0.5, 5e6).nodes, 0);
}

TEST(LeastNodes, AreNeverMoreThanTheModelNeeds) {
  const remeshd::Run run;
  for (const char* name : {"tool1-a", "tool1-c", "tool2-c", "tool3-a", "simple-a", "simple-b"}) {
    const FeatureModel model = test::case_features(name);
    const CellularModel cells = build_cells(model, run);
    for (const double edge_length : {0.01, 1.0, 100.0}) {
      const double needed = nodes_needed(extent_of(cells), edge_length);
      const double expected = expected_nodes(cells.volume, cells.area, edge_length);
      for (const double limit : {0.0, 0.1 * expected, 0.5 * expected, 0.9 * expected})
        EXPECT_LE(least_nodes(model, edge_length, limit).nodes, needed * (1 + 1e-9))
            << name << " " << edge_length << " " << limit;
    }
  }
}

}  // namespace
}  // namespace remeshd
