#include "engine/boundary/cover/cover_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/boundary/mesh_surface.h"
#include "engine/boundary/surface_crossings.h"
#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::feature;
using test::placed;

using test::kRun;

BoundaryModel boundary_of(std::vector<FeatureSource> features) {
  return build_cells(evaluate(test::model_of(std::move(features))), kRun).boundary;
}

/// A surface mesh without the facets that have a node at most `radius` from a place.
OpenSurface opened(const BoundaryModel& boundary, double length, const Vec3& place, double radius) {
  OpenSurface open;
  open.mesh = mesh_surface(boundary, {.sizes = length}, kRun);
  std::vector<std::uint8_t> stays(open.mesh.nodes.size(), 0);
  std::erase_if(open.mesh.facets, [&](const FaceFacet& f) {
    return std::ranges::any_of(
        f.nodes, [&](std::int32_t n) { return distance(open.mesh.nodes[n], place) <= radius; });
  });
  for (const FaceFacet& f : open.mesh.facets)
    for (const std::int32_t n : f.nodes) stays[n] = 1;
  for (std::size_t n = 0; n < stays.size(); ++n)
    if (stays[n] == 0) open.loose.push_back(static_cast<std::int32_t>(n));
  return open;
}

double enclosed_volume(const SurfaceMesh& mesh) {
  double six = 0;
  for (const FaceFacet& f : mesh.facets)
    six += dot(mesh.nodes[f.nodes[0]], cross(mesh.nodes[f.nodes[1]], mesh.nodes[f.nodes[2]]));
  return six / 6;
}

void expect_closed(const SurfaceMesh& mesh, const BoundaryModel& boundary) {
  std::set<std::pair<int, int>> sides;
  for (const FaceFacet& f : mesh.facets)
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(sides.emplace(f.nodes[i], f.nodes[(i + 1) % 3]).second);
  for (const auto& [a, b] : sides) EXPECT_TRUE(sides.contains({b, a})) << a << " " << b;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    EXPECT_LE(distance(mesh.nodes[n], project(boundary, mesh.supports[n], mesh.nodes[n])), 1e-9);
  EXPECT_TRUE(surface_crossings(mesh, kRun).empty());
}

/// Opens the surface about a place, covers it, and looks at what came of it.
void expect_covered(const BoundaryModel& boundary, const Vec3& place, double radius) {
  const double length = 1;
  OpenSurface open = opened(boundary, length, place, radius);
  const double volume = enclosed_volume(mesh_surface(boundary, {.sizes = length}, kRun));
  const std::size_t stay = open.mesh.facets.size();
  ASSERT_EQ(cover_open_faces(open, boundary, length, kRun), "");
  EXPECT_GT(open.mesh.facets.size(), stay);
  expect_closed(open.mesh, boundary);
  EXPECT_NEAR(enclosed_volume(open.mesh), volume, 0.02 * volume);
}

TEST(CoverOpenFaces, OfAPlaneAtAnEdgeAndAtAVertex) {
  const BoundaryModel bar = boundary_of({block("bar", 12, 6, 6)});
  expect_covered(bar, {0, 0, 6}, 2);
  expect_covered(bar, {0, 3, 6}, 2);
  expect_covered(bar, {6, 3, 6}, 2);
}

TEST(CoverOpenFaces, RoundAHoleAndAllOfIt) {
  const BoundaryModel plate = boundary_of(
      {block("plate", 12, 12, 4), placed(cylinder("hole", 2, 6), 0, 0, -1, Nature::Subtractive)});
  expect_covered(plate, {2, 0, 4}, 1.2);
  expect_covered(plate, {0, 0, 4}, 3.5);
  expect_covered(plate, {0, 0, 2}, 3.5);
}

TEST(CoverOpenFaces, OfCurvedFaces) {
  expect_covered(boundary_of({feature("ball", "sphere", {{"radius", 4.0}})}), {4, 0, 0}, 3);
  expect_covered(
      boundary_of({feature("cone", "cone",
                           {{"radius_bottom", 5.0}, {"radius_top", 0.0}, {"height", 8.0}})}),
      {0, 0, 8}, 3);
  expect_covered(
      boundary_of({feature("ring", "torus", {{"major_radius", 8.0}, {"minor_radius", 3.0}})}),
      {11, 0, 0}, 3);
}

// A wall of a thousandth of an edge length: its two sides get the same nodes, but for .3 edge
// lengths within the rim, where the pocket's floor has none inside of it.
TEST(CoverOpenFaces, BothSidesOfAFilmAlike) {
  const BoundaryModel pocket =
      boundary_of({block("plate", 12, 12, 4),
                   placed(cylinder("pocket", 2, 4), 0, 0, 1e-3, Nature::Subtractive)});
  OpenSurface open = opened(pocket, 1, {0, 0, 0}, 4.5);
  ASSERT_EQ(cover_open_faces(open, pocket, 1, kRun), "");
  expect_closed(open.mesh, pocket);
  std::set<std::array<double, 2>> floor, bottom;
  for (const FaceFacet& f : open.mesh.facets)
    for (const std::int32_t n : f.nodes) {
      const Vec3& p = open.mesh.nodes[n];
      const std::array<double, 2> at{std::round(1e6 * p.x), std::round(1e6 * p.y)};
      if (std::hypot(p.x, p.y) > 1.55) continue;
      if (p.z == 0) bottom.insert(at);
      if (std::fabs(p.z - 1e-3) < 1e-9) floor.insert(at);
    }
  EXPECT_GT(floor.size(), 5U);
  EXPECT_EQ(floor, bottom);
}

TEST(CoverOpenFaces, FacetsAreSmallerWhereThatIsAskedFor) {
  const BoundaryModel bar = boundary_of({block("bar", 12, 6, 6)});
  OpenSurface open = opened(bar, 1, {0, 0, 6}, 2), finer = open;
  finer.finer_at = {{0, 0, 6}};
  ASSERT_EQ(cover_open_faces(open, bar, 1, kRun), "");
  ASSERT_EQ(cover_open_faces(finer, bar, 1, kRun), "");
  expect_closed(finer.mesh, bar);
  EXPECT_GT(finer.mesh.facets.size(), open.mesh.facets.size());
}

}  // namespace
}  // namespace remeshd
