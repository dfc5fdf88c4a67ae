#include "engine/optimise/active_samples.h"

#include <gmock/gmock.h>

namespace remeshd {
namespace {

constexpr double kSpacing = 0.25;

/// Samples along a line of 20, a quarter apart, and a fixed node at every whole number.
struct Line {
  Samples samples;
  NodeSet nodes;
  NearestToPoints nearest{{}, 1};

  Line() {
    for (int k = 0; k <= 80; ++k)
      samples.points.push_back({{kSpacing * k, 0, 0}, 1, {Support::Kind::Face, 0}});
    samples.edges_begin = samples.vertices_begin = samples.points.size();
    for (int n = 0; n <= 20; ++n) {
      nodes.add_new({1.0 * n, 0, 0}, {Support::Kind::Face, 0});
      nodes.state.back() = NodeState::Fixed;
    }
    nearest = NearestToPoints(samples.positions(), 0.8);
  }
  /// Whether each sample whose place on the line is in [lo, hi] takes part, and no other.
  [[nodiscard]] bool takes_part(const ActiveSamples& active, double lo, double hi) const {
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t s = 0; s < samples.points.size(); ++s)
      if (samples.points[s].position.x >= lo && samples.points[s].position.x <= hi)
        wanted.push_back(s);
    return active.participants() == wanted;
  }
};

TEST(ActiveSamples, OfAFirstMeshAreAll) {
  const Line line;
  const ActiveSamples active(line.samples);
  EXPECT_EQ(active.active_count(), 81U);
  EXPECT_TRUE(line.takes_part(active, 0, 20));
}

TEST(ActiveSamples, HaveAFreeNodeNearestAndTheirNeighboursAreBorderActive) {
  Line line;
  line.nodes.state[10] = NodeState::Free;
  const ActiveSamples active(line.nodes, 1, line.nearest, remeshd::Run{});
  // Nearest to node 10: from 9.75 to 10.25; at 9.5 and 10.5 the lower index wins, 9 and 10.
  EXPECT_EQ(active.active_count(), 4U);
  EXPECT_TRUE(line.takes_part(active, 9.75 - 0.6, 10.5 + 0.6));
}

TEST(ActiveSamples, RestWhereNoNodeIsFree) {
  Line line;
  const ActiveSamples active(line.nodes, 1, line.nearest, remeshd::Run{});
  EXPECT_EQ(active.active_count(), 0U);
  EXPECT_TRUE(active.participants().empty());
}

TEST(ActiveSamples, ThatPullOnAFreeNodeBecomeActiveWithTheirNeighbours) {
  Line line;
  line.nodes.state[10] = NodeState::Free;
  ActiveSamples active(line.nodes, 1, line.nearest, remeshd::Run{});
  active.promote(std::vector<std::uint32_t>{44});  // at 11, border-active
  EXPECT_EQ(active.active_count(), 5U);
  EXPECT_TRUE(line.takes_part(active, 9.75 - 0.6, 11 + 0.6));
}

TEST(ActiveSamples, GrowWithTheFreeNodes) {
  Line line;
  line.nodes.state[10] = NodeState::Free;
  ActiveSamples active(line.nodes, 1, line.nearest, remeshd::Run{});
  line.nodes.state[9] = line.nodes.state[11] = NodeState::Free;
  active.refresh(line.nodes, remeshd::Run{});
  EXPECT_EQ(active.active_count(), 12U);
  EXPECT_TRUE(line.takes_part(active, 8.75 - 0.6, 11.5 + 0.6));
}

}  // namespace
}  // namespace remeshd
