#include "engine/remesh/carry_over.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

const remeshd::Run kRun;
/// Of the original's tet, in another slot.
const PeeledMesh kPeeled{{{0, 1, 2, 4}}, {7}, {}};

/// A Delaunay mesh of one tet, for which the delivered mesh has two with a fifth node: as after the
/// last resort, whose delivered mesh is more than clean-up makes of the peeled Delaunay mesh.
struct Original : OriginalPart {
  Original() {
    positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    delivered_nodes = positions;
    tets = {{0, 1, 2, 4}};
    delivered = {{0, 1, 2, 3}, {1, 2, 3, 4}};
    pieces = find_pieces(tets, delivered, {}, positions.size(), kRun);
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

CarriedMesh carry(const Original& original, const NodeSet& nodes) {
  const std::vector<Transform> transforms{Transform{}};
  return carry_over(nodes, kPeeled, original, transforms, kRun);
}

TEST(CarryOver, BringsWhatTheCleanUpMadeOfATet) {
  const Original original;
  const CarriedMesh carried = carry(original, copies_of(original, 5));
  EXPECT_EQ(carried.mesh.tets, original.delivered);
  EXPECT_EQ(carried.dirty, (std::vector<std::uint8_t>{0, 0}));
}

TEST(CarryOver, LeavesTetsWhoseNodesAreNotAllThere) {
  const Original original;
  NodeSet nodes = copies_of(original, 5);
  nodes.original[3] = nodes.transform[3] = -1;  // only the delivered tets have the fourth node
  const CarriedMesh carried = carry(original, nodes);
  EXPECT_EQ(carried.mesh.tets, (std::vector<Tet>{{0, 1, 2, 4}}));
  EXPECT_EQ(carried.dirty, (std::vector<std::uint8_t>{1}));
}

TEST(CarryOver, LeavesTetsWhoseNodesWentDifferentWays) {
  const Original original;
  NodeSet nodes = copies_of(original, 5);
  nodes.transform[3] = 1;
  Transform away;
  away.m[3] = 0.5;
  nodes.positions[3] = away.apply(nodes.positions[3]);
  const CarriedMesh carried =
      carry_over(nodes, kPeeled, original, std::vector<Transform>{Transform{}, away}, kRun);
  EXPECT_EQ(carried.mesh.tets, kPeeled.tets);
}

}  // namespace
}  // namespace remeshd
