#include "engine/patch/stitch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/base/random.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// Three blocks side by side in x, of length 2, 2 and 1; the second and the third begin at
/// 2 + `moved` and 4 + `moved`.
FeatureModel blocks(double moved) {
  const auto from = [](double x, const FeatureSource& block, double dx) {
    return test::placed(block, x + dx / 2, 1, 0);
  };
  return evaluate(test::model_of({from(0, test::block("stays", 2, 2, 2), 2),
                                  from(2 + moved, test::block("larger", 2, 2, 2), 2),
                                  from(4 + moved, test::block("smaller", 1, 2, 2), 1)}));
}

/// All of a Delaunay mesh as the mesh of the model, nothing cleaned up.
PeeledMesh all_of(const DelaunayMesh& mesh) {
  PeeledMesh peeled;
  mesh.for_each_tet_with_neighbours([&](std::int32_t slot, const Tet& tet, const Tet&) {
    peeled.tets.push_back(tet);
    peeled.slots.push_back(slot);
  });
  return peeled;
}

StitchedMesh stitched(const Revision& original, const MeshPatch& cut, const NodeSet& nodes,
                      const DelaunayMesh& mesh, const CopyPlan& plan) {
  const PeeledMesh peeled = all_of(mesh);
  const TetMesh as_peeled{nodes.positions, peeled.tets};
  const SameTets unknown;
  return stitch(original, CowVector<Support>(original.supports().size(), {}), cut,
                {nodes, mesh, peeled, as_peeled, unknown}, plan, kRun);
}

/// A first mesh of nodes at random in the blocks, and an edit that moves the second block and the
/// third: nodes go the way that their place says, so that tets across x = 2 are pulled apart.
class MovedBlocks : public testing::Test {
 protected:
  static constexpr double kBy = 1e-6;  // so little that the mesh stays Delaunay

  MovedBlocks() {
    const FeatureModel model = blocks(0);
    DelaunayMesh mesh(bounds());
    NodeSet nodes;
    Random random(1);
    for (int n = 0; n < 60; ++n)
      nodes.add_new({random.uniform(0, 5), random.uniform(0, 2), random.uniform(0, 2)});
    std::vector<std::int32_t> all(60);
    std::iota(all.begin(), all.end(), 0);
    mesh.insert(nodes.positions, all, kRun);
    StitchedMesh first =
        stitched(Revision::none(), {}, nodes, mesh, CopyPlan({}, model, {1}, kRun));
    original_.model = model;
    original_.output.mesh = std::move(first.mesh);
    original_.output.map = std::move(first.map);
    original_.delaunay_state =
        std::make_shared<const DelaunayState>(std::move(first.delaunay_state));
  }
  static Box bounds() {
    Box box;
    box.add(Vec3{0, 0, 0});
    box.add(Vec3{6, 2, 2});
    return box;
  }
  std::int32_t other_transform() const { return 1 - plan_.identity(); }

  StitchedMesh edited() const {
    const std::vector<std::uint8_t> inner(original_.output.mesh.nodes.size(), 1);
    const MeshPatch cut = cut_patch(copied_mesh(original_), inner, nullptr);
    NodeSet nodes;
    std::vector<std::int32_t> moved;
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(cut.nodes.size()); ++n) {
      const bool stays = cut.positions[n].x < 2;
      const std::int32_t t = stays ? plan_.identity() : other_transform();
      nodes.add_new(plan_.transforms()[t].apply(cut.positions[n]));
      nodes.original[n] = n;
      nodes.transform[n] = t;
      if (!stays) moved.push_back(n);
    }
    DelaunayMesh mesh = cut.mesh;
    EXPECT_EQ(mesh.move(nodes.positions, moved, kRun), DelaunayMesh::Moved::Done);
    return stitched(original_, cut, nodes, mesh, plan_);
  }

  Revision original_;
  const CopyPlan plan_{blocks(0), blocks(kBy), {0.5}, kRun};
};

TEST_F(MovedBlocks, TetsOfAFirstMeshStandInTheOrderOfTheirLowestNodes) {
  std::vector<std::int32_t> lowest;
  for (const Tet& t : original_.output.mesh.tets) lowest.push_back(std::ranges::min(t));
  EXPECT_TRUE(std::ranges::is_sorted(lowest));
}

TEST_F(MovedBlocks, ATetIsKeptWhereItsNodesWentOneWay) {
  ASSERT_EQ(plan_.transforms().size(), 2U);
  const StitchedMesh whole = edited();
  ASSERT_EQ(whole.mesh.tets.size(), original_.output.mesh.tets.size());
  const NodeMap& map = whole.map;
  std::size_t kept = 0, across = 0;
  for (std::size_t t = 0; t < whole.mesh.tets.size(); ++t) {
    const Tet& tet = whole.mesh.tets[t];
    ASSERT_TRUE(std::ranges::all_of(
        tet, [&](std::int32_t n) { return map.node_origin[n] == NodeOrigin::Kept; }));
    const bool one_way = std::ranges::all_of(
        tet, [&](std::int32_t n) { return map.node_transform[n] == map.node_transform[tet[0]]; });
    EXPECT_EQ(map.original_tet[t], one_way ? static_cast<std::int32_t>(t) : -1) << t;
    ++(one_way ? kept : across);
  }
  EXPECT_GT(kept, 50U);
  EXPECT_GT(across, 20U) << "tets across x = 2";
}

TEST_F(MovedBlocks, ATransformIsNamedAfterTheFirstFeatureThatHasIt) {
  const StitchedMesh whole = edited();
  ASSERT_EQ(whole.map.transform_features.size(), 2U);
  EXPECT_EQ(whole.map.transform_features[plan_.identity()], "stays");
  EXPECT_EQ(whole.map.transform_features[other_transform()], "larger") << "the most to copy";
}

}  // namespace
}  // namespace remeshd
