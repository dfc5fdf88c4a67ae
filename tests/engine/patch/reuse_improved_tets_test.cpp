#include "engine/patch/reuse_improved_tets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "engine/mesh/quality.h"
#include "engine/optimise/live_mesh.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
/// Of the original's tet, in another slot.
const PeeledMesh kPeeled{{{0, 1, 2, 4}}, {7}, {}};

/// A Delaunay mesh of one tet, for which the output mesh has two with a fifth node: as after the
/// last resort, whose output mesh is more than clean-up makes of the peeled Delaunay mesh.
struct Original : MeshPatch {
  Original() {
    positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    output_nodes = positions;
    tets = {{0, 1, 2, 4}};
    output = {{0, 1, 2, 3}, {1, 2, 3, 4}};
    cavities = find_cavities(tets, output, {}, positions.size(), CavityExtent::Connected, kRun);
  }
};

NodeSet copies_of(const Original& original, std::int32_t count) {
  NodeSet nodes;
  for (std::int32_t n = 0; n < count; ++n) {
    nodes.add_new(original.positions[n]);
    nodes.original[n] = n;
    nodes.transform[n] = 0;
  }
  return nodes;
}

ReusedMesh reuse(const Original& original, const NodeSet& nodes) {
  const std::vector<Transform> transforms{Transform{}};
  return reuse_improved_tets(nodes, kPeeled, original, transforms, nullptr, kRun);
}

TEST(CarryOver, BringsWhatTheCleanUpMadeOfATet) {
  const Original original;
  const ReusedMesh reused = reuse(original, copies_of(original, 5));
  EXPECT_EQ(reused.mesh.tets, original.output);
  EXPECT_EQ(reused.dirty, (std::vector<std::uint8_t>{0, 0}));
}

TEST(CarryOver, LeavesTetsWhoseNodesAreNotAllThere) {
  const Original original;
  NodeSet nodes = copies_of(original, 5);
  nodes.original[3] = nodes.transform[3] = -1;  // only the output tets have the fourth node
  const ReusedMesh reused = reuse(original, nodes);
  EXPECT_EQ(reused.mesh.tets, (std::vector<Tet>{{0, 1, 2, 4}}));
  EXPECT_EQ(reused.dirty, (std::vector<std::uint8_t>{1}));
}

TEST(CarryOver, LeavesTetsWhoseNodesWentDifferentWays) {
  const Original original;
  NodeSet nodes = copies_of(original, 5);
  nodes.transform[3] = 1;
  Transform away;
  away.m[3] = 0.5;
  nodes.positions[3] = away.apply(nodes.positions[3]);
  const ReusedMesh reused = reuse_improved_tets(
      nodes, kPeeled, original, std::vector<Transform>{Transform{}, away}, nullptr, kRun);
  EXPECT_EQ(reused.mesh.tets, kPeeled.tets);
}

/// A tet whose fourth node clean-up has moved to (.8, .8, 1), and the Delaunay mesh of an edit that
/// has it still, with a new node beside it that the moved node is beyond: between them a tet that
/// is good over the nodes of the Delaunay mesh and inverted over those of the output.
struct BesideNewNode : testing::Test {
  BesideNewNode() {
    original.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}};
    original.output_nodes = original.positions;
    original.output_nodes[3] = {0.8, 0.8, 1};
    original.tets = original.output = {{0, 1, 2, 3}};
    original.cavities =
        find_cavities(original.tets, original.output, {}, 4, CavityExtent::Connected, kRun);
    nodes = copies_of(original, 4);
    nodes.add_new({0.7, 0.7, 0.9});
  }
  ReusedMesh reuse() const {
    return reuse_improved_tets(nodes, {{{0, 1, 2, 3}, {1, 2, 3, 4}}, {7, 8}, {}}, original,
                               std::vector<Transform>{Transform{}}, nullptr, kRun);
  }

  Original original;
  NodeSet nodes;
};

TEST_F(BesideNewNode, WhatWouldBeSpoiltIsGivenBack) {
  const ReusedMesh reused = reuse();
  EXPECT_EQ(reused.mesh.nodes, nodes.positions);
  EXPECT_EQ(reused.mesh.tets, (std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}}));
  EXPECT_EQ(reused.dirty, (std::vector<std::uint8_t>{1, 1}));
}

TEST_F(BesideNewNode, WhatWouldNotBeSpoiltIsCarried) {
  nodes.positions[4] = {2, 2, 1};
  const ReusedMesh reused = reuse();
  EXPECT_EQ(reused.mesh.nodes[3], original.output_nodes[3]);
  EXPECT_EQ(reused.dirty, (std::vector<std::uint8_t>{0, 1}));
}

TEST_F(BesideNewNode, AtTheInterfaceThePatchIsTooSmall) {
  nodes.interface_nodes = 4;
  EXPECT_THROW(reuse(), PatchTooSmall);
}

/// Two tets on either side of a facet, in the place of which the new Delaunay mesh has three round
/// the edge from 3 to 4, beside a tet that stays. Clean-up has moved a node of that.
struct Flipped : testing::Test {
  Flipped() {
    original.positions = {{1, 0, 0}, {-0.5, 0.87, 0}, {-0.5, -0.87, 0},
                          {0, 0, 1}, {0, 0, -1},      {1, 1.6, 0.3}};
    original.output_nodes = original.positions;
    original.output_nodes[5] = {1, 1.7, 0.3};
    original.tets = {{0, 1, 2, 3}, {1, 0, 2, 4}, {1, 0, 5, 3}};
    original.output = original.tets;
    original.inside = {1, 1, 1};
    original.cavities =
        find_cavities(original.tets, original.output, {}, 6, CavityExtent::Least, kRun);
    nodes = copies_of(original, 6);
  }
  [[nodiscard]] ReusedMesh reuse(const std::function<bool(const Tet&)>& unchanged) const {
    return reuse_improved_tets(nodes, peeled, original, std::vector<Transform>{Transform{}},
                               unchanged, kRun);
  }

  Original original;
  NodeSet nodes;
  const PeeledMesh peeled{
      {{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}, {1, 0, 5, 3}}, {7, 8, 9, 2}, {}};
};

TEST_F(Flipped, TetsOfTheSameHullAreTheOriginals) {
  for (const Tet& t : peeled.tets) ASSERT_GT(volume_length(original.positions, t), 0);
  for (const Tet& t : original.tets) ASSERT_GT(volume_length(original.positions, t), 0);
  const ReusedMesh reused = reuse([](const Tet&) { return true; });
  EXPECT_EQ(reused.mesh.tets, (std::vector<Tet>{{1, 0, 5, 3}, {0, 1, 2, 3}, {1, 0, 2, 4}}));
  EXPECT_EQ(reused.dirty, (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(reused.same.peeled, (std::vector<std::int32_t>{3, -1, -1}));
  EXPECT_EQ(reused.same.output, (std::vector<std::int32_t>{2, 0, 1}));
}

TEST_F(Flipped, TetsStayWhereTheModelChanged) {
  const auto is_far_from_4 = [](const Tet& t) { return std::ranges::count(t, 4) == 0; };
  for (const auto& unchanged : {std::function<bool(const Tet&)>(is_far_from_4), {}}) {
    const ReusedMesh reused = reuse(unchanged);
    EXPECT_EQ(reused.mesh.tets, peeled.tets);
    EXPECT_EQ(reused.dirty, (std::vector<std::uint8_t>{1, 1, 1, 0}));
  }
}

TEST_F(Flipped, TetsStayWhereANodeHasMovedIn) {
  nodes.positions[5] = {0.02, 0.01, 0.1};
  const PeeledMesh round_it{
      {{0, 1, 5, 3}, {5, 1, 2, 3}, {0, 5, 2, 3}, {1, 0, 5, 4}, {5, 0, 2, 4}, {1, 5, 2, 4}},
      {7, 8, 9, 10, 11, 12},
      {}};
  for (const Tet& t : round_it.tets) ASSERT_GT(volume_length(nodes.positions, t), 0);
  const ReusedMesh reused = reuse_improved_tets(
      nodes, round_it, original, std::vector<Transform>{Transform{}},
      [](const Tet&) { return true; }, kRun);
  EXPECT_EQ(reused.mesh.tets, round_it.tets);
}

TEST_F(Flipped, TetsThatWouldBeInvertedAreNotTakenBack) {
  original.positions[4] = nodes.positions[4] = {0, 0, 0.5};  // above the facet 0 1 2
  const ReusedMesh reused = reuse([](const Tet&) { return true; });
  EXPECT_EQ(reused.mesh.tets, peeled.tets);
}

}  // namespace
}  // namespace remeshd
