#include "engine/extract/peel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// A cube with a node in its middle and one at each vertex but the last `missing`.
PeeledMesh peeled_cube(int missing) {
  const FeatureModel model = evaluate(test::one_feature(test::block("b", 2, 2, 2)));
  const CellularModel cells = build_cells(model, kRun);
  const BoundaryModel& boundary = cells.boundary;
  const Membership membership(model);
  NodeSet nodes;
  nodes.add_new(0.5 * (boundary.bounds.lo + boundary.bounds.hi));
  for (int v = 0; v + missing < static_cast<int>(boundary.vertices.size()); ++v)
    nodes.add_new(boundary.vertices[v].position, {Support::Kind::Vertex, v});
  DelaunayMesh delaunay(boundary.bounds);
  std::vector<std::int32_t> all(nodes.positions.size());
  std::iota(all.begin(), all.end(), 0);
  delaunay.insert(nodes.positions, all, kRun);
  return peel(
      nodes, delaunay, boundary, [&](const Vec3& p) { return membership.inside(p); },
      KnownClassification::nothing(delaunay), {}, kRun);
}

TEST(Peel, OfACubeLeavesTwoTetsOnEachSide) {
  const PeeledMesh mesh = peeled_cube(0);
  EXPECT_EQ(mesh.tets.size(), 12U);
  EXPECT_TRUE(mesh.nonconforming.empty());
}

TEST(Peel, TellsWhereABoundaryFacetIsOnNoFace) {
  const PeeledMesh mesh = peeled_cube(1);
  ASSERT_EQ(mesh.nonconforming.size(), 1U);
  const FeatureModel model = evaluate(test::one_feature(test::block("b", 2, 2, 2)));
  const CellularModel cells = build_cells(model, kRun);
  EXPECT_NEAR(distance(mesh.nonconforming[0], cells.boundary.vertices.back().position),
              2 / std::sqrt(3.0), 1e-9);
}

/// The mesh of one tet between the two sides of a slot, its centroid in the upper one.
PeeledMesh peeled_across_a_slot(const PeelOptions& options) {
  const FeatureModel model = evaluate(
      test::model_of({test::block("b", 10, 10, 10),
                      test::placed(test::block("slot", 6, 20, 2), 5, 0, 4, Nature::Subtractive)}));
  const CellularModel cells = build_cells(model, kRun);
  const Membership membership(model);
  const auto face_at = [&](const Vec3& p) {
    for (std::size_t f = 0; f < cells.boundary.faces.size(); ++f)
      if (face_distance2(cells.boundary.faces[f], p) < 1e-18) return static_cast<int>(f);
    return -1;
  };
  NodeSet nodes;
  for (const Vec3& p : {Vec3{5, 0, 9}, Vec3{5, 3, 7}, Vec3{3, 3, 6}, Vec3{5, 1, 3.9}})
    nodes.add_new(p, {Support::Kind::Face, face_at(p)});
  DelaunayMesh delaunay(cells.boundary.bounds);
  const std::vector<std::int32_t> all{0, 1, 2, 3};
  delaunay.insert(nodes.positions, all, kRun);
  return peel(
      nodes, delaunay, cells.boundary, [&](const Vec3& p) { return membership.inside(p); },
      KnownClassification::nothing(delaunay), options, kRun);
}

TEST(Peel, LeavesOutATetAcrossAGapWhereEdgesAreAsked) {
  EXPECT_EQ(peeled_across_a_slot({}).tets.size(), 1U);
  EXPECT_TRUE(peeled_across_a_slot({.edges_too = true}).tets.empty());
}

/// Two nodes along and two across on a torus's outermost circle, nearly in one plane, and one
/// within the tube.
PeeledMesh peeled_torus(const PeelOptions& options) {
  const FeatureModel model = evaluate(test::one_feature(
      test::feature("ring", "torus", {{"major_radius", 4.0}, {"minor_radius", 1.0}})));
  const CellularModel cells = build_cells(model, kRun);
  const Membership membership(model);
  NodeSet nodes;
  nodes.add_new({4, 0, 0});
  const auto add = [&](double along, double across) {  // angles
    const double r = 4 + std::cos(across);
    nodes.add_new({r * std::cos(along), r * std::sin(along), std::sin(across)},
                  {Support::Kind::Face, 0});
  };
  for (const double sign : {-1.0, 1.0}) {
    add(0.12 * sign, 0);
    add(0, 0.3 * sign);
  }
  DelaunayMesh delaunay(cells.boundary.bounds);
  std::vector<std::int32_t> all(nodes.positions.size());
  std::iota(all.begin(), all.end(), 0);
  delaunay.insert(nodes.positions, all, kRun);
  return peel(
      nodes, delaunay, cells.boundary, [&](const Vec3& p) { return membership.inside(p); },
      KnownClassification::nothing(delaunay), options, kRun);
}

TEST(Peel, AFlatTetOnACurvedFaceGoesWhereItIsOfLowQuality) {
  EXPECT_EQ(peeled_torus({.flat = 0.3}).tets.size(), 2U);
  EXPECT_EQ(peeled_torus({.flat = 0}).tets.size(), 3U);
}

}  // namespace
}  // namespace remeshd
