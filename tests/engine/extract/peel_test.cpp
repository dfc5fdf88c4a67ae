#include "engine/extract/peel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/boundary/edge_chains.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// The mesh that is peeled off the Delaunay mesh of all nodes.
PeeledMesh peeled(const NodeSet& nodes, const FeatureModel& model, const BoundaryModel& boundary,
                  const PeelOptions& options) {
  const Membership membership(model);
  DelaunayMesh delaunay(boundary.bounds);
  std::vector<std::int32_t> all(nodes.positions.size());
  std::iota(all.begin(), all.end(), 0);
  delaunay.insert(nodes.positions, all, kRun);
  return peel(
      nodes, delaunay, boundary, [&](const Vec3& p) { return membership.inside(p); },
      KnownClassification::nothing(delaunay), options, kRun);
}

/// A cube with a node in its middle and one at each vertex but the last `missing`.
PeeledMesh peeled_cube(int missing) {
  const FeatureModel model = evaluate(test::one_feature(test::block("b", 2, 2, 2)));
  const CellularModel cells = build_cells(model, kRun);
  const BoundaryModel& boundary = cells.boundary;
  NodeSet nodes;
  nodes.add_new(0.5 * (boundary.bounds.lo + boundary.bounds.hi));
  for (int v = 0; v + missing < static_cast<int>(boundary.vertices.size()); ++v)
    nodes.add_new(boundary.vertices[v].position, {Support::Kind::Vertex, v});
  return peeled(nodes, model, boundary, {});
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

/// The face that a point lies on.
int face_at(const BoundaryModel& boundary, const Vec3& p) {
  const auto found = std::ranges::min_element(
      boundary.faces, {}, [&](const BoundaryFace& face) { return face_distance2(face, p); });
  return static_cast<int>(found - boundary.faces.begin());
}

/// The mesh of one tet between the two sides of a slot, its centroid in the upper one.
PeeledMesh peeled_across_a_slot(const PeelOptions& options) {
  const FeatureModel model = evaluate(
      test::model_of({test::block("b", 10, 10, 10),
                      test::placed(test::block("slot", 6, 20, 2), 5, 0, 4, Nature::Subtractive)}));
  const CellularModel cells = build_cells(model, kRun);
  NodeSet nodes;
  for (const Vec3& p : {Vec3{5, 0, 9}, Vec3{5, 3, 7}, Vec3{3, 3, 6}, Vec3{5, 1, 3.9}})
    nodes.add_new(p, {Support::Kind::Face, face_at(cells.boundary, p)});
  return peeled(nodes, model, cells.boundary, options);
}

TEST(Peel, LeavesOutATetAcrossAGapWhereEdgesAreAsked) {
  EXPECT_EQ(peeled_across_a_slot({}).tets.size(), 1U);
  EXPECT_TRUE(peeled_across_a_slot({.by_centroid_only = false}).tets.empty());
}

TEST(Peel, KeepsATetBehindAChordOfAHoleThoughItsCentroidIsInTheHole) {
  const FeatureModel model = evaluate(
      test::model_of({test::block("plate", 30, 30, 4),
                      test::placed(test::cylinder("hole", 5, 10), 0, 0, -5, Nature::Subtractive)}));
  const CellularModel cells = build_cells(model, kRun);
  NodeSet nodes;
  for (const Vec3& p :
       {Vec3{5 * std::cos(0.2), -5 * std::sin(0.2), 3},
        Vec3{5 * std::cos(0.2), 5 * std::sin(0.2), 3}, Vec3{5, 0, 1}, Vec3{5.02, 0, 4}})
    nodes.add_new(p, {Support::Kind::Face, face_at(cells.boundary, p)});
  const auto tets_left = [&](bool by_centroid_only) {
    return peeled(nodes, model, cells.boundary, {.by_centroid_only = by_centroid_only}).tets.size();
  };
  EXPECT_EQ(tets_left(true), 0U);
  EXPECT_EQ(tets_left(false), 1U);
}

/// Two nodes along and two across on a torus's outermost circle, nearly in one plane, and one
/// within the tube.
PeeledMesh peeled_torus(const PeelOptions& options) {
  const FeatureModel model = evaluate(test::one_feature(
      test::feature("ring", "torus", {{"major_radius", 4.0}, {"minor_radius", 1.0}})));
  const CellularModel cells = build_cells(model, kRun);
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
  return peeled(nodes, model, cells.boundary, options);
}

TEST(Peel, AFlatTetOnACurvedFaceGoesWhereItIsOfLowQuality) {
  EXPECT_EQ(peeled_torus({.flat = 0.3}).tets.size(), 2U);
  EXPECT_EQ(peeled_torus({.flat = 0}).tets.size(), 3U);
}

/// The model edge or vertex nearest to a point.
Support nearest_edge(const BoundaryModel& boundary, const Vec3& p) {
  const auto found = std::ranges::min_element(boundary.edges, {}, [&](const BoundaryEdge& e) {
    return nearest_on_polyline(e.points, p).distance2;
  });
  return {Support::Kind::Edge, static_cast<int>(found - boundary.edges.begin())};
}
Support nearest_vertex(const BoundaryModel& boundary, const Vec3& p) {
  const auto found = std::ranges::min_element(
      boundary.vertices, {}, [&](const BoundaryVertex& v) { return distance(v.position, p); });
  return {Support::Kind::Vertex, static_cast<int>(found - boundary.vertices.begin())};
}

TEST(Peel, AFlatTetGoesThatReachesOverAStepAtTheEndOfItsFace) {
  // A pocket in the rim of a disc leaves a step: the disc's wall ends there on one side of a vertex
  // at half its height. A flat tet against the wall reaches from below the step to above it. Its
  // centroid is in the model, that of the tet behind its upper part is not.
  const FeatureModel model = evaluate(test::model_of(
      {test::cylinder("disc", 60, 10),
       test::placed(test::block("pocket", 40, 20, 10), 60, 10, 5, Nature::Subtractive),
       test::placed(test::cylinder("hole", 1, 20), 56, 1, -5, Nature::Subtractive)}));
  const CellularModel cells = build_cells(model, kRun);
  const BoundaryModel& boundary = cells.boundary;
  const auto on_wall = [](double degrees, double z) {
    const double angle = degrees * std::numbers::pi / 180;
    return Vec3{60 * std::cos(angle), 60 * std::sin(angle), z};
  };
  const Vec3 vertex = on_wall(0, 5), above = on_wall(0, 6.5), beside = on_wall(2, 5);
  const Vec3 below = on_wall(1, 2.5), behind{57, 1, 4.9};
  NodeSet nodes;
  nodes.add_new(vertex, nearest_vertex(boundary, vertex));
  for (const Vec3& p : {above, beside}) nodes.add_new(p, nearest_edge(boundary, p));
  for (const Vec3& p : {below, behind})
    nodes.add_new(p, {Support::Kind::Face, face_at(boundary, p)});
  const PeeledMesh mesh = peeled(nodes, model, boundary, {});
  ASSERT_EQ(mesh.tets.size(), 1U);
  EXPECT_EQ(std::ranges::count(mesh.tets[0], 1), 0);  // that below the step
}

/// How many tets are left of those between four nodes round the foot of a pin on a plate, nearly in
/// one plane and on one circle, a node below them and one in the pin.
std::size_t tets_at_a_pins_foot(bool node_in_pin, bool by_centroid_only) {
  const FeatureModel model = evaluate(test::model_of(
      {test::block("plate", 40, 40, 5), test::placed(test::cylinder("pin", 1, 6), 0, 0, 5)}));
  const CellularModel cells = build_cells(model, kRun);
  constexpr double kRounding = 1e-12;
  const Support rim = nearest_edge(cells.boundary, {1, 0, 5});
  NodeSet nodes;
  for (const double sign : {-1.0, 1.0}) {
    nodes.add_new({sign, 0, 5 + kRounding}, rim);
    nodes.add_new({0, sign, 5 - kRounding}, rim);
  }
  nodes.add_new({0, 0, 3.5});
  if (node_in_pin) nodes.add_new({0, 0, 7});
  return peeled(nodes, model, cells.boundary, {.by_centroid_only = by_centroid_only}).tets.size();
}

TEST(Peel, KeepsAFlatTetOnAPlaneWhereThereIsMaterialOnBothSides) {
  EXPECT_EQ(tets_at_a_pins_foot(true, true), 4U) << "two below, two above, none between";
  EXPECT_EQ(tets_at_a_pins_foot(true, false), 5U);
  EXPECT_EQ(tets_at_a_pins_foot(false, false), 2U) << "nothing above";
}

TEST(Peel, KeepsAThinTetBelowTheTopOfAConeThatIsNearlyAPoint) {
  const FeatureModel model = evaluate(test::one_feature(test::feature(
      "c", "cone", {{"radius_bottom", 5.0}, {"radius_top", 0.01}, {"height", 10.0}})));
  const CellularModel cells = build_cells(model, kRun);
  const double third = 2 * std::numbers::pi / 3;
  NodeSet nodes;
  for (const double angle : {0.5 * third, 1.5 * third, 2.5 * third}) {
    const Vec3 p{0.01 * std::cos(angle), 0.01 * std::sin(angle), 10};
    nodes.add_new(p, nearest_edge(cells.boundary, p));
  }
  const Vec3 on_wall{0.01 + 0.499, 0, 9};
  nodes.add_new(on_wall, {Support::Kind::Face, face_at(cells.boundary, on_wall)});
  nodes.add_new({-0.1, 0, 8.5});
  const PeeledMesh mesh = peeled(nodes, model, cells.boundary, {.by_centroid_only = false});
  EXPECT_TRUE(std::ranges::any_of(mesh.tets, [](const Tet& t) {
    return std::ranges::count(t, 4) == 0;  // the top, its rim's nodes and the one on the wall
  }));
}

TEST(Peel, AnEdgeAlongWhereTwoFeaturesTouchStaysInTheModel) {
  // By rounding a point of the plane between two features may be in neither: z = 5 here.
  const FeatureModel model = evaluate(test::one_feature(test::block("b", 10, 10, 10)));
  const CellularModel cells = build_cells(model, kRun);
  const Membership membership(model);
  NodeSet nodes;
  for (const Vec3& p : {Vec3{-5, 0, 5}, Vec3{5, 0, 5}, Vec3{0, 5, 3}, Vec3{0, -5, 8}})
    nodes.add_new(p, {Support::Kind::Face, face_at(cells.boundary, p)});
  DelaunayMesh delaunay(cells.boundary.bounds);
  const std::vector<std::int32_t> all{0, 1, 2, 3};
  delaunay.insert(nodes.positions, all, kRun);
  const PeeledMesh mesh = peel(
      nodes, delaunay, cells.boundary,
      [&](const Vec3& p) { return p.z != 5 && membership.inside(p); },
      KnownClassification::nothing(delaunay), {.by_centroid_only = false}, kRun);
  EXPECT_EQ(mesh.tets.size(), 1U);
}

TEST(Peel, AFlatTetThatWasOutsideGoesThoughAllRoundItIsOutAlready) {
  // Those that were peeled after it are beyond the patch.
  const FeatureModel model = evaluate(test::one_feature(test::cylinder("c", 5, 30)));
  const CellularModel cells = build_cells(model, kRun);
  NodeSet nodes;
  for (const auto& [angle, z] :
       {std::pair{-0.1, 10.0}, std::pair{0.1, 10.1}, std::pair{0.0, 9.5}, std::pair{0.02, 10.6}}) {
    const Vec3 p{5 * std::cos(angle), 5 * std::sin(angle), z};
    nodes.add_new(p, {Support::Kind::Face, face_at(cells.boundary, p)});
  }
  DelaunayMesh delaunay(cells.boundary.bounds);
  const std::vector<std::int32_t> all{0, 1, 2, 3};
  delaunay.insert(nodes.positions, all, kRun);
  const auto tets_left = [&](KnownClassification::Known known) {
    KnownClassification before = KnownClassification::nothing(delaunay);
    std::ranges::fill(before.tets, known);
    return peel(
               nodes, delaunay, cells.boundary, [](const Vec3&) { return true; }, before, {}, kRun)
        .tets.size();
  };
  EXPECT_EQ(tets_left(KnownClassification::Known::No), 1U);
  EXPECT_EQ(tets_left(KnownClassification::Known::WasOutside), 0U);
}

}  // namespace
}  // namespace remeshd
