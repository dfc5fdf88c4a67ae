#include "engine/boundary/edge_chains.h"

#include <gtest/gtest.h>

#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

TEST(EdgeChains, RunAlongTheCurveFromStartToEnd) {
  const auto s = test::make_box({3, 1, 1}, 9, 4);
  const auto chains = edge_chains(s.boundary, s.supports, s.mesh.nodes);
  ASSERT_EQ(chains.size(), 12U);
  for (std::size_t e = 0; e < chains.size(); ++e) {
    const BoundaryEdge& edge = s.boundary.edges[e];
    EXPECT_EQ(s.mesh.nodes[chains[e].front().node], edge.points.front());
    EXPECT_EQ(s.mesh.nodes[chains[e].back().node], edge.points.back());
    EXPECT_EQ(chains[e].size(), edge.length > 2 ? 10U : 4U);
    double length = 0;
    for (std::size_t i = 0; i + 1 < chains[e].size(); ++i)
      length += distance(s.mesh.nodes[chains[e][i].node], s.mesh.nodes[chains[e][i + 1].node]);
    EXPECT_NEAR(length, edge.length, 1e-12) << "no step goes back";
    EXPECT_EQ(chains[e].front().at, 0);
    EXPECT_EQ(chains[e].back().at, polyline_length(edge));
  }
}

TEST(EdgeChains, OfAClosedEdgeWithoutVertexComeBackToTheirFirstNode) {
  const auto s = test::make_cylinder(2, 1, 20, 4);
  for (const auto& chain : edge_chains(s.boundary, s.supports, s.mesh.nodes)) {
    EXPECT_EQ(chain.size(), 21U);
    EXPECT_EQ(chain.front().node, chain.back().node);
    EXPECT_GT(chain.back().at, chain[19].at);
  }
}

}  // namespace
}  // namespace remeshd
