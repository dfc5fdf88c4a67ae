#include "engine/boundary/mesh_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/boundary/surface_crossings.h"
#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::placed;

using test::kRun;

CellularModel cells_of(std::vector<FeatureSource> features) {
  return build_cells(evaluate(test::model_of(std::move(features))), kRun);
}

double length_of(const SurfaceMesh& mesh, const FaceFacet& f, int side) {
  return distance(mesh.nodes[f.nodes[side]], mesh.nodes[f.nodes[(side + 1) % 3]]);
}

double enclosed_volume(const SurfaceMesh& mesh) {
  double six = 0;
  for (const FaceFacet& f : mesh.facets)
    six += dot(mesh.nodes[f.nodes[0]], cross(mesh.nodes[f.nodes[1]], mesh.nodes[f.nodes[2]]));
  return six / 6;
}

/// Closed: every side has its opposite, on the same model edge; nodes stand on their supports.
void expect_sound(const SurfaceMesh& mesh, const BoundaryModel& boundary) {
  std::map<std::pair<int, int>, int> sides;
  for (const FaceFacet& f : mesh.facets)
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(sides.emplace(std::pair{f.nodes[i], f.nodes[(i + 1) % 3]}, f.edge[i]).second);
  for (const auto& [side, edge] : sides) {
    const auto opposite = sides.find({side.second, side.first});
    ASSERT_NE(opposite, sides.end());
    EXPECT_EQ(opposite->second, edge);
  }
  ASSERT_EQ(mesh.supports.size(), mesh.nodes.size());
  std::size_t vertices = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec3 there = project(boundary, mesh.supports[n], mesh.nodes[n]);
    EXPECT_LE(distance(mesh.nodes[n], there), 1e-9 * boundary.bounds.diagonal());
    vertices += mesh.supports[n].kind == Support::Kind::Vertex ? 1 : 0;
  }
  EXPECT_EQ(vertices, boundary.vertices.size());
  EXPECT_TRUE(surface_crossings(mesh, kRun).empty());
}

class SurfaceOf : public testing::TestWithParam<const char*> {};

TEST_P(SurfaceOf, IsClosedOnItsModelAndEven) {
  const CellularModel cells = build_cells(test::case_features(GetParam()), kRun);
  constexpr double kLength = 5;
  const SurfaceMesh mesh = mesh_surface(cells.boundary, {.sizes = kLength}, kRun);
  expect_sound(mesh, cells.boundary);
  EXPECT_NEAR(enclosed_volume(mesh), cells.volume, 0.02 * cells.volume);
  double sum = 0;
  for (const FaceFacet& f : mesh.facets)
    for (int i = 0; i < 3; ++i) {
      sum += length_of(mesh, f, i);
      EXPECT_LT(length_of(mesh, f, i), 1.6 * kLength);
    }
  const double mean = sum / static_cast<double>(3 * mesh.facets.size());
  EXPECT_GT(mean, 0.5 * kLength);
  EXPECT_LT(mean, 1.1 * kLength);
}

INSTANTIATE_TEST_SUITE_P(Cases, SurfaceOf,
                         testing::Values("simple-a", "tool1-a", "tool2-a", "tool2-d", "tool3-a"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(MeshSurface, AnEdgeLengthLargerThanTheModelLeavesWhatItsShapeNeeds) {
  const CellularModel cells = cells_of({cylinder("c", 5, 10)});
  const SurfaceMesh mesh = mesh_surface(cells.boundary, {.sizes = 100}, kRun);
  expect_sound(mesh, cells.boundary);
  EXPECT_LT(mesh.nodes.size(), 60U);
  EXPECT_GT(enclosed_volume(mesh), 0.8 * cells.volume);
}

TEST(MeshSurface, SidesBesideAThinFaceAreAboutAsLongAsItIsWide) {
  const CellularModel cells = cells_of({block("plate", 40, 40, 1)});
  const SurfaceMesh mesh = mesh_surface(cells.boundary, {.sizes = 5}, kRun);
  expect_sound(mesh, cells.boundary);
  for (const FaceFacet& f : mesh.facets) {
    const Vec3 n = normal(cells.boundary.faces[f.face].surface, {});
    if (std::fabs(n.z) > 0.5) continue;  // a face of width 1
    for (int i = 0; i < 3; ++i) EXPECT_LT(length_of(mesh, f, i), 3.1);
  }
}

TEST(MeshSurface, WhereChordsOfNearWallsWouldCutEachOtherFacetsAreSmaller) {
  // The hole's wall keeps 0.05 from the interface's, whose chords of length 6 lie 0.09 deep.
  const CellularModel cells =
      cells_of({cylinder("plate", 50, 12),
                placed(cylinder("hole", 10, 12), 39.95, 0, 0, Nature::Subtractive)});
  expect_sound(mesh_surface(cells.boundary, {.sizes = 6}, kRun), cells.boundary);
}

TEST(MeshSurface, AFaceBetweenAnArcAndItsChordStays) {
  // The boss's corners stand out of the collar, whose sides stand out of the boss.
  const CellularModel cells =
      cells_of({block("plate", 200, 200, 40), placed(block("boss", 47.7, 39.1, 160), 0, 0, 0),
                placed(cylinder("collar", 25.84, 25.84), 0, 0, 40)});
  const SurfaceMesh mesh = mesh_surface(cells.boundary, {.sizes = 45}, kRun);
  expect_sound(mesh, cells.boundary);
  std::vector<double> area(cells.boundary.faces.size(), 0);
  for (const FaceFacet& f : mesh.facets) {
    const Vec3& a = mesh.nodes[f.nodes[0]];
    area[f.face] += 0.5 * norm(cross(mesh.nodes[f.nodes[1]] - a, mesh.nodes[f.nodes[2]] - a));
  }
  for (std::size_t f = 0; f < area.size(); ++f)
    EXPECT_NEAR(area[f], cells.boundary.faces[f].area, 0.3 * cells.boundary.faces[f].area);
}

TEST(MeshSurface, NoNodeStandsBetweenAnArcAndItsChord) {
  // The boss all but touches the collar's rim from within: 0.003 of its top are left there.
  const CellularModel cells =
      cells_of({cylinder("collar", 2.2036, 3), placed(cylinder("boss", 1.1899, 5), 0, -1.0108, 0)});
  const SurfaceMesh mesh = mesh_surface(cells.boundary, {.sizes = 2.2}, kRun);
  expect_sound(mesh, cells.boundary);
  int on_top = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec3& p = mesh.nodes[n];
    if (std::fabs(p.z - 3) > 1e-9) continue;
    ++on_top;
    EXPECT_GT(std::hypot(p.x, p.y + 1.0108), 1.1899 - 1e-9) << "node " << n;
  }
  EXPECT_GT(on_top, 10);
}

TEST(MeshSurface, EachOfTwoEdgesBetweenTheSameFacesHasTheNodesNearIt) {
  // The ring leaves the block through a side and comes back: loops that `project` may confuse.
  const CellularModel cells = cells_of(
      {block("b", 34.9971, 53.401, 22.8141),
       placed(test::feature("r", "torus", {{"major_radius", 10.1277}, {"minor_radius", 1.3575}}),
              14.1619, -1.0384, 3.2407)});
  const SurfaceMesh mesh = mesh_surface(cells.boundary, {.sizes = 4.702}, kRun);
  expect_sound(mesh, cells.boundary);
  for (std::size_t e = 0; e < cells.boundary.edges.size(); ++e) {
    Box box;
    for (const Vec3& p : cells.boundary.edges[e].points) box.add(p);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      if (mesh.supports[n] == Support{Support::Kind::Edge, static_cast<std::int32_t>(e)}) {
        EXPECT_TRUE(box.contains(mesh.nodes[n], 0.1)) << "edge " << e << " node " << n;
      }
  }
}

TEST(MeshSurface, IsTheSameEveryTime) {
  const CellularModel cells = build_cells(test::case_features("tool2-d"), kRun);
  const SurfaceMesh a = mesh_surface(cells.boundary, {.sizes = 4}, kRun);
  const SurfaceMesh b = mesh_surface(cells.boundary, {.sizes = 4}, kRun);
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.supports, b.supports);
  EXPECT_TRUE(std::ranges::equal(a.facets, b.facets, {}, &FaceFacet::nodes, &FaceFacet::nodes));
}

TEST(SurfaceCrossings, FindsAFacetThroughAnotherAndNoneBesideIt) {
  SurfaceMesh mesh;
  mesh.nodes = {{0, 0, 0}, {4, 0, 0},  {0, 4, 0}, {1, 1, -1}, {1, 1, 1},
                {1, 2, 1}, {5, 5, -1}, {5, 5, 1}, {5, 6, 1}};
  for (const Triangle& t : {Triangle{0, 1, 2}, {3, 4, 5}, {6, 7, 8}})
    mesh.facets.push_back({t, {-1, -1, -1}, 0});
  const auto found = surface_crossings(mesh, kRun);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(std::min(found[0].first, found[0].second), 0);
  EXPECT_EQ(std::max(found[0].first, found[0].second), 1);
  // Whichever of the two has the side that cuts the other.
  std::swap(mesh.facets[0], mesh.facets[1]);
  EXPECT_EQ(surface_crossings(mesh, kRun).size(), 1U);
}

}  // namespace
}  // namespace remeshd
