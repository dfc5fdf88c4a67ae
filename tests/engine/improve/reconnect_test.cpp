#include "engine/improve/reconnect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/mesh/quality.h"
#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

double volume(const TetMesh& mesh) { return measure_quality(mesh.nodes, mesh.tets, {}).volume; }

/// `count` tets round the edge 0-1 (from z = -half to half), with ring nodes 2, 3, ... on a circle
/// of radius 1 through `turn`.
TetMesh wheel(int count, double half, double turn = 2 * std::numbers::pi) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, -half}, {0, 0, half}};
  const bool closed = turn > 6;
  const int nodes = closed ? count : count + 1;
  for (int i = 0; i < nodes; ++i)
    mesh.nodes.push_back({std::cos(turn * i / count), std::sin(turn * i / count), 0});
  for (int i = 0; i < count; ++i) mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % nodes});
  return mesh;
}

/// A model of one plane face, z = 0, looking down, on which all nodes stand that `on_plane` names.
struct PlaneModel {
  BoundaryModel boundary;
  std::vector<Support> supports;
  PlaneModel(std::size_t nodes, const std::vector<int>& on_plane) : supports(nodes) {
    BoundaryFace face;
    face.reversed = true;
    boundary.faces.push_back(face);
    for (const int n : on_plane) supports[n] = {Support::Kind::Face, 0};
  }
};

TetMesh apply(const LocalMesh& mesh, const Reconnection& r) {
  LocalMesh copy = mesh;
  std::vector<std::int32_t> slots;
  copy.replace(r.old_tets, r.fresh, slots);
  return copy.result();
}

TEST(EdgeRing, OfAnInteriorEdgeIsClosedAndTurnsPositively) {
  const LocalMesh mesh(wheel(5, 1));
  EdgeRing ring;
  ASSERT_TRUE(mesh.ring(0, 1, 8, ring));
  EXPECT_TRUE(ring.closed);
  EXPECT_EQ(ring.tets, 5);
  EXPECT_EQ(ring.nodes, 5);
  for (int i = 0; i < 5; ++i)
    EXPECT_GT(tet_volume(mesh.node(0), mesh.node(1), mesh.node(ring.node[i]),
                         mesh.node(ring.node[(i + 1) % 5])),
              0);
  EXPECT_FALSE(mesh.ring(0, 1, 4, ring)) << "larger than asked for";
  EXPECT_FALSE(mesh.ring(2, 4, 8, ring)) << "not an edge";
}

TEST(EdgeRing, OfABoundaryEdgeIsOpenFromOneFacetToTheOther) {
  const LocalMesh mesh(wheel(3, 1, std::numbers::pi));
  EdgeRing ring;
  ASSERT_TRUE(mesh.ring(0, 1, 8, ring));
  EXPECT_FALSE(ring.closed);
  EXPECT_EQ(ring.tets, 3);
  EXPECT_EQ(ring.nodes, 4);
  EXPECT_EQ(ring.node[0], 2);
  EXPECT_EQ(ring.node[3], 5);
}

class RemoveEdgeRings : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rings, RemoveEdgeRings, testing::Range(3, 9));

TEST_P(RemoveEdgeRings, ReplacesATallThinRingByTwoFansOfTheSameVolume) {
  const int count = GetParam();
  const TetMesh before = wheel(count, 3);
  const LocalMesh mesh(before);
  const PlaneModel model(before.nodes.size(), {});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  ASSERT_TRUE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
  const TetMesh after = apply(mesh, out);
  EXPECT_EQ(after.tets.size(), static_cast<std::size_t>(2 * (count - 2)));
  EXPECT_NEAR(volume(after), volume(before), 1e-12);
  const Quality quality = measure_quality(after.nodes, after.tets, {});
  EXPECT_NEAR(quality.volume_length_min, out.quality, 1e-15);
  EXPECT_GT(out.quality, measure_quality(before.nodes, before.tets, {}).volume_length_min);
  EXPECT_FALSE(LocalMesh(after).joined(0, 1));
}

TEST(RemoveEdge, FindsTheBestOfAllTriangulationsOfAPentagon) {
  TetMesh before = wheel(5, 2.5);
  before.nodes[2] = {1.8, 0.2, 0.1};
  before.nodes[4] = {-0.5, 0.6, -0.1};
  const LocalMesh mesh(before);
  const PlaneModel model(before.nodes.size(), {});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  double best = -1;
  for (int fan = 0; fan < 5; ++fan) {  // the five triangulations of a pentagon are fans
    double worst = 1;
    for (int k = 1; k < 4; ++k) {
      const Vec3& i = before.nodes[2 + fan];
      const Vec3& j = before.nodes[2 + (fan + k) % 5];
      const Vec3& l = before.nodes[2 + (fan + k + 1) % 5];
      worst = std::min({worst, volume_length(before.nodes[0], i, j, l),
                        volume_length(before.nodes[1], i, l, j)});
    }
    best = std::max(best, worst);
  }
  Reconnection out;
  ASSERT_TRUE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
  EXPECT_NEAR(out.quality, best, 1e-15);
}

TEST(RemoveEdge, DoesNotTouchARingThatItCannotRaiseAboveTheFloor) {
  const TetMesh before = wheel(6, 2);
  const LocalMesh mesh(before);
  const PlaneModel model(before.nodes.size(), {});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  ASSERT_TRUE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
  EXPECT_FALSE(remove_edge(mesh, rules, 0, 1, 8, out.quality, out));
}

/// Two tets on the square 0 2 1 3 of the plane z = 0, apex 4, split along the long diagonal 0-1.
TetMesh kite() {
  TetMesh mesh;
  mesh.nodes = {{-1.5, 0, 0}, {1.5, 0, 0}, {0, -0.6, 0}, {0, 0.6, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 4, 2}, {0, 1, 3, 4}};
  for (Tet& t : mesh.tets)
    if (tet_volume(mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]], mesh.nodes[t[3]]) < 0)
      std::swap(t[2], t[3]);
  return mesh;
}

TEST(RemoveEdge, FlipsTheDiagonalOfAPlaneFace) {
  const TetMesh before = kite();
  const LocalMesh mesh(before);
  const PlaneModel model(5, {0, 1, 2, 3});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  ASSERT_TRUE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
  const TetMesh after = apply(mesh, out);
  EXPECT_EQ(after.tets.size(), 2U);
  EXPECT_TRUE(LocalMesh(after).joined(2, 3));
  EXPECT_FALSE(LocalMesh(after).joined(0, 1));
  EXPECT_NEAR(volume(after), volume(before), 1e-15);
}

TEST(RemoveEdge, LeavesABoundaryEdgeWhoseNodesStandOnNoCommonFace) {
  const TetMesh before = kite();
  const LocalMesh mesh(before);
  const PlaneModel model(5, {0, 1, 2});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  EXPECT_FALSE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
}

TEST(RemoveEdge, NeverSwapsAModelEdge) {
  const TetMesh before = kite();
  const LocalMesh mesh(before);
  PlaneModel model(5, {2, 3});
  model.boundary.vertices = {{before.nodes[0], {}}, {before.nodes[1], {}}};
  test::add_line(model.boundary, 0, 1, {0});
  model.supports[0] = {Support::Kind::Vertex, 0};
  model.supports[1] = {Support::Kind::Vertex, 1};
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  EXPECT_FALSE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
}

TEST(RemoveEdge, NeverMakesAConcaveQuadrilateralItsOtherDiagonal) {
  TetMesh before = kite();
  before.nodes[2] = {-2.5, -0.6, 0};  // the diagonal 2-3 passes outside of the facets
  for (Tet& t : before.tets)
    ASSERT_GT(
        tet_volume(before.nodes[t[0]], before.nodes[t[1]], before.nodes[t[2]], before.nodes[t[3]]),
        0);
  const LocalMesh mesh(before);
  const PlaneModel model(5, {0, 1, 2, 3});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  EXPECT_FALSE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
}

// The flat tet 0 1 2 3 on the face hides the inner edge 2-3 of the two tets behind it.
TEST(RemoveEdge, PeelsAFlatTetOffAPlaneFace) {
  TetMesh before = kite();
  before.tets = {{2, 3, 4, 0}, {2, 3, 1, 4}, {0, 1, 2, 3}};
  before.nodes[0].z = before.nodes[1].z = -1e-14;
  for (Tet& t : before.tets)
    if (tet_volume(before.nodes[t[0]], before.nodes[t[1]], before.nodes[t[2]], before.nodes[t[3]]) <
        0)
      std::swap(t[2], t[3]);
  const LocalMesh mesh(before);
  const PlaneModel model(5, {0, 1, 2, 3});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  ASSERT_TRUE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
  EXPECT_TRUE(out.fresh.empty());
  EXPECT_EQ(out.quality, std::numeric_limits<double>::infinity());
  const TetMesh after = apply(mesh, out);
  EXPECT_EQ(after.tets.size(), 2U);
  EXPECT_NEAR(volume(after), volume(before), 1e-13);
}

TEST(RemoveEdge, DoesNotPeelATetWhoseInnerEdgeIsOnTheSurfaceAlready) {
  TetMesh before = kite();
  before.tets = {{0, 1, 2, 3}};
  before.nodes[0].z = before.nodes[1].z = -0.01;
  if (volume(before) < 0) std::swap(before.tets[0][2], before.tets[0][3]);
  const LocalMesh mesh(before);
  const PlaneModel model(5, {0, 1, 2, 3});
  const BoundaryRules rules(model.boundary, model.supports, mesh, 0.05);
  Reconnection out;
  EXPECT_FALSE(remove_edge(mesh, rules, 0, 1, 8, -1, out));
}

TEST(RemoveFaces, IsATwoThreeFlipForTwoTetsWithFarApexesNear) {
  TetMesh before;
  before.nodes = {{0, 0, 0.25}, {0, 0, -0.25}, {1, 0, 0}, {-0.5, 0.9, 0}, {-0.5, -0.9, 0}};
  before.tets = {{0, 2, 4, 3}, {1, 2, 3, 4}};
  ASSERT_GT(volume(before), 0);
  const LocalMesh mesh(before);
  Reconnection out;
  ASSERT_TRUE(remove_faces(mesh, 0, 0, -1, out));
  const TetMesh after = apply(mesh, out);
  EXPECT_EQ(after.tets.size(), 3U);
  EXPECT_TRUE(LocalMesh(after).joined(0, 1));
  EXPECT_NEAR(volume(after), volume(before), 1e-15);
  EXPECT_GT(measure_quality(after.nodes, after.tets, {}).volume_length_min,
            measure_quality(before.nodes, before.tets, {}).volume_length_min);
}

TEST(RemoveFaces, UndoesEdgeRemovalOfAWholeRing) {
  // Six flat pairs on a hexagon: one edge between the apexes serves all of them.
  const TetMesh ring = wheel(6, 0.8);
  TetMesh before;
  before.nodes = ring.nodes;
  for (int i = 1; i < 5; ++i) {
    before.tets.push_back({0, 2, 2 + i, 3 + i});
    before.tets.push_back({1, 2, 3 + i, 2 + i});
  }
  ASSERT_NEAR(volume(before), volume(ring), 1e-12);
  const LocalMesh mesh(before);
  Reconnection out;
  ASSERT_TRUE(remove_faces(mesh, 2, 0, 0.85, out)) << "only all facets together get that far";
  const TetMesh after = apply(mesh, out);
  EXPECT_EQ(after.tets.size(), 6U);
  EXPECT_NEAR(volume(after), volume(ring), 1e-12);
  EXPECT_NEAR(out.quality, measure_quality(ring.nodes, ring.tets, {}).volume_length_min, 1e-12);
}

TEST(RemoveFaces, LeavesAFacetOfTheBoundary) {
  const TetMesh before = kite();
  Reconnection out;
  for (int corner = 0; corner < 4; ++corner)
    EXPECT_FALSE(remove_faces(LocalMesh(before), 0, corner, -1, out));
}

TEST(LocalMesh, KeepsUntouchedTetsInPlaceThroughAnOperation) {
  const auto s = test::make_box({1, 1, 1}, 4, 1);
  LocalMesh mesh(s.mesh);
  std::vector<std::int32_t> slots;
  const std::vector<std::int32_t> gone{5, 9};
  const std::vector<Tet> fresh{s.mesh.tets[9], s.mesh.tets[5]};
  mesh.replace(gone, fresh, slots);
  EXPECT_EQ(slots, gone) << "freed slots are used again";
  for (std::int32_t t = 0; t < mesh.slots(); ++t)
    if (t != 5 && t != 9) {
      EXPECT_EQ(mesh.tet(t), s.mesh.tets[t]);
      EXPECT_EQ(mesh.stamp(t), 0U);
    }
  EXPECT_GT(mesh.stamp(5), 0U);
  for (std::int32_t n = 0; n < 27; ++n)
    for (const std::int32_t t : mesh.tets_of(n))
      EXPECT_NE(std::find(mesh.tet(t).begin(), mesh.tet(t).end(), n), mesh.tet(t).end());
}

}  // namespace
}  // namespace remeshd
