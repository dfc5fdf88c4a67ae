#include "engine/optimise/live_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/base/random.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// Nodes in the unit cube, all but the first `fixed` free.
NodeSet cloud(int count, int fixed) {
  Random random(3);
  NodeSet nodes;
  for (int k = 0; k < count; ++k) {
    nodes.add_new({random.uniform(), random.uniform(), random.uniform()});
    nodes.state.back() = k >= fixed ? NodeState::Free : NodeState::Fixed;
  }
  return nodes;
}

DelaunayMesh empty_mesh() {
  Box box;
  box.add(Vec3{0, 0, 0});
  box.add(Vec3{1, 1, 1});
  return DelaunayMesh(box);
}

DelaunayMesh mesh_of_first(const NodeSet& nodes, int count) {
  DelaunayMesh mesh = empty_mesh();
  std::vector<std::int32_t> first(count);
  std::iota(first.begin(), first.end(), 0);
  mesh.insert(nodes.positions, first, kRun);
  return mesh;
}

std::vector<Tet> sorted(std::vector<Tet> tets) {
  for (Tet& t : tets) std::sort(t.begin(), t.end());
  std::sort(tets.begin(), tets.end());
  return tets;
}

std::vector<Tet> anew(const NodeSet& nodes) {
  std::vector<Tet> tets;
  mesh_of_first(nodes, nodes.size()).for_each_tet([&](const Tet& t) { tets.push_back(t); });
  return sorted(std::move(tets));
}

/// Moves every `each`-th free node by up to `step`, within the cube but not onto its walls, where
/// nodes would meet.
void stir(NodeSet& nodes, double step, Random& random, int each = 1) {
  for (std::int32_t n = 0; n < nodes.size(); n += each) {
    if (!nodes.is_free(n)) continue;
    Vec3& p = nodes.positions[n];
    for (double* v : {&p.x, &p.y, &p.z}) {
      const double to = *v + step * random.uniform(-1, 1);
      if (to > 0 && to < 1) *v = to;
    }
  }
}

TEST(LiveMesh, TakesInTheNodesThatTheStartLacks) {
  const NodeSet nodes = cloud(400, 150);
  std::vector<std::uint8_t> holds(400, 0);
  std::fill_n(holds.begin(), 150, 1);
  LiveMesh live(mesh_of_first(nodes, 150), holds, false, kRun);
  live.follow(nodes);
  EXPECT_EQ(sorted(live.tets()), anew(nodes));
}

TEST(LiveMesh, IsTheMeshOfTheNodesHoweverFarTheyMove) {
  for (const bool rebuild : {false, true}) {
    NodeSet nodes = cloud(400, 150);
    std::vector<std::uint8_t> holds(400, 0);
    std::fill_n(holds.begin(), 150, 1);
    LiveMesh live(mesh_of_first(nodes, 150), holds, rebuild, kRun);
    Random random(4);
    live.follow(nodes);
    for (const double step : {0.5, 0.3, 0.1, 0.3, 0.01, 0.001, 0.5}) {
      stir(nodes, step, random);
      live.follow(nodes);
      ASSERT_EQ(sorted(live.tets()), anew(nodes)) << "steps of " << step;
      // A fixed node is freed, and goes.
      nodes.state[static_cast<std::int32_t>(1000 * step) % 150] = NodeState::Free;
    }
  }
}

TEST(LiveMesh, FollowsAFewThatMoveFar) {
  NodeSet nodes = cloud(800, 0);
  LiveMesh live(empty_mesh(), {}, false, kRun);
  Random random(5);
  live.follow(nodes);
  for (int round = 0; round < 4; ++round) {
    stir(nodes, 0.5, random, 40);
    live.follow(nodes);
    ASSERT_EQ(sorted(live.tets()), anew(nodes));
  }
}

TEST(LiveMesh, TakesInNodesAddedOnTheWay) {
  NodeSet nodes = cloud(300, 100);
  LiveMesh live(empty_mesh(), {}, false, kRun);
  Random random(6);
  for (int round = 0; round < 3; ++round) {
    live.follow(nodes);
    ASSERT_EQ(sorted(live.tets()), anew(nodes));
    stir(nodes, round == 1 ? 0.4 : 0.01, random);
    for (int k = 0; k < 5; ++k)
      nodes.add_new({random.uniform(), random.uniform(), random.uniform()});
  }
}

}  // namespace
}  // namespace remeshd
