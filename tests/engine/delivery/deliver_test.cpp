#include "engine/delivery/deliver.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

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

}  // namespace
}  // namespace remeshd
