#include "engine/delivery/deliver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "engine/patch/node_map.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// A prism on a right-angled triangle of 40 x 7, whose edge at the origin is sharp (9.9 degrees),
/// 20 high, in nine tets: three at that edge and six beyond x = 20.
Revision wedge() {
  Revision r;
  r.source = test::one_feature(test::feature(
      "wedge", "prism", {test::point(0.0, 0.0), test::point(40.0, 0.0), test::point(40.0, 7.0)},
      {{"height", 20.0}}));
  r.model = evaluate(r.source);
  r.cells = build_cells(r.model, kRun);
  TetMesh mesh;
  std::vector<Support> supports;
  for (const double z : {0.0, 20.0})
    for (const auto& [x, y] :
         {std::pair{0.0, 0.0}, {20.0, 0.0}, {20.0, 3.5}, {40.0, 0.0}, {40.0, 7.0}}) {
      mesh.nodes.push_back({x, y, z});
      supports.push_back({Support::Kind::Face, 0});
      for (int v = 0; v < static_cast<int>(r.cells.boundary.vertices.size()); ++v)
        if (distance(r.cells.boundary.vertices[v].position, mesh.nodes.back()) < 1e-9)
          supports.back() = {Support::Kind::Vertex, v};
    }
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {1, 3, 4}, {1, 4, 2}})
    for (const Tet& t : {Tet{a, b, c, c + 5}, Tet{a, b, c + 5, b + 5}, Tet{a, b + 5, c + 5, a + 5}})
      mesh.tets.push_back(t);
  r.output.mesh = paged(mesh);
  DelaunayState state;
  state.supports = CowVector(supports);
  r.delaunay_state = std::make_shared<const DelaunayState>(std::move(state));
  return r;
}

/// Measured as one whose Delaunay mesh is another's.
void account_for(Revision& r) {
  std::vector<std::int32_t> all(r.output.mesh.tets.size());
  std::iota(all.begin(), all.end(), 0);
  Revision original;
  original.delaunay_state = r.delaunay_state;
  account(original, all, r.cells.volume, r, kRun);
}

TEST(Account, QualityAwayFromSharpPlacesIsThatOfTheOtherTets) {
  Revision r = wedge();
  account_for(r);
  const Report& report = r.report;
  EXPECT_NEAR(report.quality.volume, 2800, 1e-9);
  EXPECT_EQ(report.sharp_tets, 3U);
  EXPECT_NEAR(report.quality_away.volume, 2100, 1e-9) << "700 are beside the sharp edge";
  EXPECT_EQ(std::accumulate(report.quality_away.histogram.begin(),
                            report.quality_away.histogram.end(), 0U),
            6U);
  EXPECT_GE(report.quality_away.dihedral_min, report.quality.dihedral_min);
}

TEST(Account, QualityAwayIsThatOfAllTetsWhereNothingIsSharp) {
  Revision r = wedge();
  r.model = test::case_features("simple-a");
  r.cells = build_cells(r.model, kRun);
  account_for(r);
  EXPECT_EQ(r.report.sharp_tets, 0U);
  EXPECT_EQ(r.report.quality_away.volume, r.report.quality.volume);
}

TEST(Account, CountsNodesAndTetsByWhereTheyCameFrom) {
  Revision r = wedge();
  using enum NodeOrigin;
  r.output.map.node_origin = CowVector(std::vector<NodeOrigin>{Kept, Kept, Moved, New, Kept});
  r.output.map.original_tet = CowVector(std::vector<std::int32_t>{-1, 1, 2, -1});
  account_for(r);
  const Counts& counts = r.report.counts;
  EXPECT_EQ(counts.nodes, 10U);
  EXPECT_EQ(counts.tets, 9U);
  EXPECT_EQ(counts.nodes_kept, 3U);
  EXPECT_EQ(counts.nodes_moved, 1U);
  EXPECT_EQ(counts.tets_kept, 2U);
}

/// A block, and what is delivered of its own mesh as one whose nodes and tets, but for those that
/// the map says otherwise of, are those of the base.
class Delivered : public testing::Test {
 protected:
  static const Revision& base() {
    static const Revision made = make_revision(
        Revision::none(), test::one_feature(test::block("block", 4, 4, 4)), {.nodes = 60}, kRun);
    return made;
  }
  static NodeMap same(const Revision& of) { return map_kept(of, of.output.mesh.nodes); }
  static Revision to_be_meshed() {
    Revision r;
    r.source = base().source;
    r.model = base().model;
    r.cells = base().cells;
    r.edge_length = base().edge_length;
    return r;
  }
  static Revision deliver_as(NodeMap map, const Revision& original, const Revision& parent) {
    Candidate c;
    c.whole.mesh = parent.output.mesh;
    c.whole.delaunay_state = *parent.delaunay_state;
    c.whole.map = std::move(map);
    c.verification.volume = parent.report.volume;
    c.verification.surface = verified_parent(parent).surface;
    c.verification.changed_tets.resize(parent.output.mesh.tets.size());
    std::iota(c.verification.changed_tets.begin(), c.verification.changed_tets.end(), 0);
    Revision r = to_be_meshed();
    const CopyPlan plan(original.model, r.model, {r.edge_length}, kRun);
    deliver(std::move(c), original, parent, plan, r, kRun);
    return r;
  }
  static std::set<std::uint64_t> set_of(const CowVector<std::uint64_t>& ids) {
    return {ids.begin(), ids.end()};
  }
};

TEST_F(Delivered, WhatHasAnOriginalHasItsIdAndAllElseIsNew) {
  NodeMap map = same(base());
  for (const std::size_t n : {3, 8}) {
    map.original_node.edit(n) = map.node_transform.edit(n) = -1;
    map.node_origin.edit(n) = NodeOrigin::New;
  }
  for (const std::size_t t : {5, 6, 7}) map.original_tet.edit(t) = -1;
  // Two that stand in each other's place.
  std::swap(map.original_node.edit(10), map.original_node.edit(11));
  std::swap(map.original_tet.edit(12), map.original_tet.edit(13));
  const Revision r = deliver_as(map, base(), base());
  const auto check = [](const CowVector<std::uint64_t>& ids, const CowVector<std::uint64_t>& then,
                        const CowVector<std::int32_t>& original, std::size_t fresh) {
    std::set<std::uint64_t> ever = set_of(then);
    ASSERT_EQ(ids.size(), then.size());
    EXPECT_EQ(set_of(ids).size(), ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      if (original[k] >= 0)
        EXPECT_EQ(ids[k], then[original[k]]) << k;
      else
        EXPECT_TRUE(ever.insert(ids[k]).second) << k;
    }
    EXPECT_EQ(ever.size(), then.size() + fresh);
  };
  check(r.output.node_ids, base().output.node_ids, map.original_node, 2);
  check(r.output.tet_ids, base().output.tet_ids, map.original_tet, 3);
}

TEST_F(Delivered, IdsOfWhatWentAreNotUsedAgain) {
  NodeMap map = same(base());
  map.original_node.edit(3) = map.original_tet.edit(5) = -1;
  const Revision first = deliver_as(map, base(), base());
  map = same(first);
  map.original_node.edit(3) = map.original_tet.edit(5) = -1;
  const Revision second = deliver_as(map, first, first);
  const std::set<std::uint64_t> nodes{base().output.node_ids[3], first.output.node_ids[3],
                                      second.output.node_ids[3]},
      tets{base().output.tet_ids[5], first.output.tet_ids[5], second.output.tet_ids[5]};
  EXPECT_EQ(nodes.size(), 3U);
  EXPECT_EQ(tets.size(), 3U);
}

TEST_F(Delivered, AMeshThatCopiesNothingHasNoIdOfItsParent) {
  NodeMap map = same(base());
  for (std::size_t n = 0; n < map.original_node.size(); ++n) map.original_node.edit(n) = -1;
  for (std::size_t t = 0; t < map.original_tet.size(); ++t) map.original_tet.edit(t) = -1;
  const Revision r = deliver_as(map, Revision::none(), base());
  for (const auto& [now, then] : {std::pair(&r.output.node_ids, &base().output.node_ids),
                                  std::pair(&r.output.tet_ids, &base().output.tet_ids)}) {
    std::set<std::uint64_t> both = set_of(*now);
    both.merge(set_of(*then));
    EXPECT_EQ(both.size(), now->size() + then->size());
  }
}

TEST_F(Delivered, WhereTheConnectivityIsKeptADeformedTetHasItsIdButNoOriginal) {
  CowVector<Vec3> nodes = base().output.mesh.nodes;
  constexpr std::int32_t kMoved = 7;
  nodes.edit(kMoved).x += 1e-3;
  std::vector<std::int32_t> at_moved;
  for (std::size_t t = 0; t < base().output.mesh.tets.size(); ++t)
    if (std::ranges::count(base().output.mesh.tets[t], kMoved) > 0)
      at_moved.push_back(static_cast<std::int32_t>(t));
  Revision r = to_be_meshed();
  deliver_kept(base(), nodes, at_moved, r);
  EXPECT_EQ(r.output.node_ids, base().output.node_ids);
  EXPECT_EQ(r.output.tet_ids, base().output.tet_ids);
  EXPECT_EQ(r.output.mesh.tets, base().output.mesh.tets);
  ASSERT_FALSE(at_moved.empty());
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(r.output.mesh.tets.size()); ++t)
    EXPECT_EQ(r.output.map.original_tet[t], std::ranges::binary_search(at_moved, t) ? -1 : t);
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(nodes.size()); ++n) {
    EXPECT_EQ(r.output.map.original_node[n], n);
    EXPECT_EQ(r.output.map.node_origin[n], n == kMoved ? NodeOrigin::Moved : NodeOrigin::Kept);
  }
}

}  // namespace
}  // namespace remeshd
