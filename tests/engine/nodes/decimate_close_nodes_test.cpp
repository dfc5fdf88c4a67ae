#include "engine/nodes/decimate_close_nodes.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

constexpr Support kFace{Support::Kind::Face, 3}, kOtherFace{Support::Kind::Face, 4};
constexpr Support kEdge{Support::Kind::Edge, 1};

/// Nodes on a line, free, with their supports.
CopiedNodes on_a_line(const std::vector<std::pair<double, Support>>& places) {
  CopiedNodes nodes;
  for (const auto& [x, support] : places) {
    nodes.add_new({x, 0, 0}, support);
    nodes.original.back() = nodes.transform.back() = 0;
  }
  return nodes;
}

std::vector<double> left(const CopiedNodes& nodes) {
  std::vector<double> x;
  for (const Vec3& p : nodes.positions) x.push_back(p.x);
  return x;
}

TEST(ThinOut, NewNodesGoBeforeCopies) {
  CopiedNodes nodes = on_a_line({{0, {}}, {1, {}}});
  nodes.add_new({0.3, 0, 0});
  decimate_close_nodes(nodes, 1);
  EXPECT_EQ(left(nodes), (std::vector<double>{0, 1}));
}

TEST(ThinOut, NodesInsideGoBeforeThoseOfABoundary) {
  CopiedNodes nodes = on_a_line({{0, {}}, {0.3, kFace}});
  decimate_close_nodes(nodes, 1);
  EXPECT_EQ(left(nodes), (std::vector<double>{0.3}));
}

TEST(ThinOut, BothSidesOfAThinWallKeepTheirNodes) {
  CopiedNodes nodes = on_a_line({{0, kFace}, {0.2, kOtherFace}});
  decimate_close_nodes(nodes, 1);
  EXPECT_EQ(nodes.size(), 2);
}

TEST(ThinOut, ACrowdOnOneEdgeLosesEveryOther) {
  CopiedNodes nodes = on_a_line({{0, kEdge}, {0.2, kEdge}, {0.4, kEdge}, {0.6, kEdge}, {1, kEdge}});
  decimate_close_nodes(nodes, 1);
  EXPECT_EQ(left(nodes), (std::vector<double>{0, 0.4, 1}));
}

TEST(ThinOut, FixedNodesAndVerticesStay) {
  CopiedNodes nodes = on_a_line(
      {{0, {}}, {0.1, {}}, {0.2, {Support::Kind::Vertex, 0}}, {0.3, {Support::Kind::Vertex, 1}}});
  nodes.state[0] = nodes.state[1] = NodeState::Fixed;
  decimate_close_nodes(nodes, 1);
  EXPECT_EQ(nodes.size(), 4);
}

}  // namespace
}  // namespace remeshd
