#include "engine/optimise/pull.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/fill.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

void pull(NodeSet& nodes, const BoundaryModel& boundary, const Samples& samples,
          std::span<const std::uint32_t> active, const PullOptions& options) {
  NearestToPoints nearest(samples.positions(), options.edge_length);
  pull_boundary(nodes, boundary, Adjacency(boundary), samples, active, nearest, options, kRun);
}

struct Scene {
  FeatureModel model;
  CellularModel cells;
  Membership membership;
  Samples samples;
  std::vector<std::uint32_t> everything;

  Scene(const std::string& name, double l)
      : model(test::case_features(name)),
        cells(build_cells(model, kRun)),
        membership(model),
        samples(sample_boundary(cells.boundary, membership, l, 1, {}, kRun)),
        everything(samples.points.size()) {
    std::iota(everything.begin(), everything.end(), 0U);
  }
  NodeSet random_nodes(std::uint32_t count, double l) const {
    NodeSet nodes;
    for (const Vec3& p : fill_random(
             {membership.bounds()}, [&](const Vec3& q) { return membership.inside(q); },
             {.edge_length = l, .count = count}, kRun))
      nodes.add_new(p);
    return nodes;
  }
};

TEST(PullBoundary, EveryVertexGetsANode) {
  const Scene s("tool3-a", 5);
  NodeSet nodes = s.random_nodes(1200, 5);
  pull(nodes, s.cells.boundary, s.samples, s.everything, {.edge_length = 5});
  std::vector<int> at(s.cells.boundary.vertices.size(), 0);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.supports[n].kind == Support::Kind::Vertex) {
      ++at[nodes.supports[n].entity];
      EXPECT_EQ(nodes.positions[n], s.cells.boundary.vertices[nodes.supports[n].entity].position);
    }
  for (const int count : at) EXPECT_EQ(count, 1);
}

TEST(PullBoundary, PulledNodesStandOnTheirEntityAndTheOthersAreInterior) {
  const Scene s("tool1-a", 5);
  NodeSet nodes = s.random_nodes(1200, 5);
  const NodeSet before = nodes;
  pull(nodes, s.cells.boundary, s.samples, s.everything, {.edge_length = 5});
  int boundary = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (nodes.supports[n].kind == Support::Kind::Interior) {
      EXPECT_EQ(nodes.positions[n], before.positions[n]);
      continue;
    }
    ++boundary;
    EXPECT_LT(distance(project(s.cells.boundary, nodes.supports[n], nodes.positions[n]),
                       nodes.positions[n]),
              1e-9);
  }
  EXPECT_GT(boundary, 400);
}

TEST(PullBoundary, FixedNodesStay) {
  const Scene s("simple-a", 8);
  NodeSet nodes = s.random_nodes(600, 8);
  for (std::int32_t n = 0; n < nodes.size(); ++n) nodes.free[n] = nodes.positions[n].x > 0;
  const NodeSet before = nodes;
  std::vector<std::uint32_t> right;
  for (const std::uint32_t k : s.everything)
    if (s.samples.points[k].position.x > 15) right.push_back(k);
  pull(nodes, s.cells.boundary, s.samples, right, {.edge_length = 8});
  int moved = 0;
  for (std::int32_t n = 0; n < before.size(); ++n) {
    if (!before.free[n] && nodes.free[n] == 0) {
      EXPECT_EQ(nodes.positions[n], before.positions[n]);
    }
    moved += nodes.positions[n] != before.positions[n];
  }
  EXPECT_GT(moved, 50);
}

TEST(PullBoundary, ANodeBetweenTwoFarSidesIsSplit) {
  // A plate thinner than the edge length: one node in the middle serves neither of its sides.
  FeatureModel model = evaluate(test::one_feature(
      test::feature("plate", "block", {{"dx", 20.0}, {"dy", 20.0}, {"dz", 1.0}})));
  const CellularModel cells = build_cells(model, kRun);
  const Membership membership(model);
  const Samples samples = sample_boundary(cells.boundary, membership, 4, 1, {}, kRun);
  std::vector<std::uint32_t> faces(samples.edges_begin);
  std::iota(faces.begin(), faces.end(), 0U);
  NodeSet nodes;
  for (double x = -8; x <= 8; x += 4)
    for (double y = -8; y <= 8; y += 4) nodes.add_new({x, y, 0.5});
  pull(nodes, cells.boundary, samples, faces, {.edge_length = 4});
  EXPECT_GE(nodes.size(), 50);
  int top = 0, bottom = 0;
  for (const Vec3& p : nodes.positions) {
    top += p.z == 1;
    bottom += p.z == 0;
  }
  EXPECT_GE(top, 25);
  EXPECT_GE(bottom, 25);
}

TEST(Adjacency, TellsBluntFromSharpAndFromApart) {
  // The stiffener of tool2-d: its slope runs into the pipe's wall at 40 degrees.
  const Scene s("tool2-d", 5);
  const Adjacency adjacency(s.cells.boundary);
  int sharp = 0, blunt = 0, apart = 0;
  const int faces = static_cast<int>(s.cells.boundary.faces.size());
  for (int a = 0; a < faces; ++a)
    for (int b = a + 1; b < faces; ++b) {
      const Meeting m = adjacency.meeting(Support::Kind::Face, a, b);
      EXPECT_EQ(m, adjacency.meeting(Support::Kind::Face, b, a));
      (m == Meeting::Sharp ? sharp : m == Meeting::Blunt ? blunt : apart)++;
    }
  EXPECT_GE(sharp, 1);
  EXPECT_LE(sharp, 3);
  EXPECT_GT(blunt, 20);
  EXPECT_GT(apart, blunt);
}

}  // namespace
}  // namespace remeshd
