#include "engine/verify/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/support/solid_fixture.h"
#include "tests/support/tet_neighbours.h"

namespace remeshd {
namespace {

using test::make_box;
using test::make_cylinder;
using test::SolidFixture;

Verification check(const SolidFixture& s) {
  return verify(s.mesh, s.supports, s.boundary, s.volume, {});
}

std::string report(const Verification& v) {
  std::string text;
  for (const MeshDefect& f : v.failures) text += f.what + "\n";
  return text;
}

const MeshDefect* first(const Verification& v, MeshFailure kind) {
  const auto it = std::find_if(v.failures.begin(), v.failures.end(),
                               [&](const MeshDefect& f) { return f.kind == kind; });
  return it == v.failures.end() ? nullptr : &*it;
}

std::int32_t find_node(const SolidFixture& s, Support::Kind kind) {
  const auto it = std::find_if(s.supports.begin(), s.supports.end(),
                               [&](const Support& support) { return support.kind == kind; });
  return static_cast<std::int32_t>(it - s.supports.begin());
}

/// Index of the first tet with so many nodes on the boundary, none of its facets exposed, and, if
/// there are two, these two joined by a boundary edge within one face.
std::size_t inner_tet(const SolidFixture& s, int on_boundary) {
  const auto neighbours = test::tet_neighbours(s.mesh.tets, s.mesh.nodes.size());
  const auto on_face = [&](std::int32_t n) { return s.supports[n].kind == Support::Kind::Face; };
  const auto on_any = [&](std::int32_t n) { return s.supports[n].kind != Support::Kind::Interior; };
  for (std::size_t t = 0; t < s.mesh.tets.size(); ++t) {
    const Tet& tet = s.mesh.tets[t];
    if (std::count_if(tet.begin(), tet.end(), on_any) != on_boundary) continue;
    if (std::count_if(tet.begin(), tet.end(), on_face) != on_boundary) continue;
    if (std::count(neighbours[t].begin(), neighbours[t].end(), -1) != 0) continue;
    if (on_boundary < 2) return t;
    std::vector<std::int32_t> pair;
    std::copy_if(tet.begin(), tet.end(), std::back_inserter(pair), on_face);
    for (std::size_t u = 0; u < s.mesh.tets.size(); ++u)
      for (int i = 0; i < 4; ++i) {
        if (neighbours[u][i] >= 0) continue;
        int shared = 0;
        for (int k = 0; k < 4; ++k)
          if (k != i && (s.mesh.tets[u][k] == pair[0] || s.mesh.tets[u][k] == pair[1])) ++shared;
        if (shared == 2) return t;
      }
  }
  ADD_FAILURE() << "the fixture has no such tet";
  return 0;
}

TEST(Verify, AcceptsABoxAndKnowsItsVolumeAndArea) {
  const SolidFixture s = make_box({2, 1, 1}, 8, 1);
  const Verification v = check(s);
  EXPECT_TRUE(v.valid) << report(v);
  EXPECT_NEAR(v.volume, 2.0, 1e-12);
  EXPECT_NEAR(v.boundary_area, 10.0, 1e-12);
}

TEST(Verify, AcceptsACylinderWhoseFacetsCutItsChords) {
  const SolidFixture s = make_cylinder(10, 8, 48, 1);
  const Verification v = check(s);
  EXPECT_TRUE(v.valid) << report(v);
  EXPECT_LT(v.volume, s.volume);
  EXPECT_GT(v.volume, 0.998 * s.volume);
}

TEST(Verify, FindsAnInvertedTetWhereItIs) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  std::swap(s.mesh.tets[17][0], s.mesh.tets[17][1]);
  const Verification v = check(s);
  EXPECT_FALSE(v.valid);
  ASSERT_EQ(v.count(MeshFailure::BadTet), 1U);
  const MeshDefect* defect = first(v, MeshFailure::BadTet);
  EXPECT_EQ(defect->entity, 17);
  Vec3 centroid;
  for (const std::int32_t n : s.mesh.tets[17]) centroid += 0.25 * s.mesh.nodes[n];
  EXPECT_LT(distance(defect->place, centroid), 1e-12);
  EXPECT_THAT(defect->what, testing::HasSubstr("inverted"));
}

TEST(Verify, FindsAFlatTet) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const std::size_t t = inner_tet(s, 0);
  const Tet tet = s.mesh.tets[t];
  s.mesh.nodes[tet[0]] = (s.mesh.nodes[tet[1]] + s.mesh.nodes[tet[2]] + s.mesh.nodes[tet[3]]) / 3.0;
  const Verification v = check(s);
  EXPECT_TRUE(std::any_of(v.failures.begin(), v.failures.end(), [&](const MeshDefect& f) {
    return f.kind == MeshFailure::BadTet && f.entity == static_cast<std::int32_t>(t) &&
           f.what.find("flat") != std::string::npos;
  })) << report(v);
}

TEST(Verify, FindsANodeThatIsNotANumber) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  s.mesh.nodes[find_node(s, Support::Kind::Interior)].y = std::nan("");
  EXPECT_GT(check(s).count(MeshFailure::BadTet), 0U);
  EXPECT_EQ(check(s).count(MeshFailure::Volume), 1U);
}

TEST(Verify, FindsTetsThatOverlapAcrossAFacet) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  s.mesh.tets.push_back(s.mesh.tets[inner_tet(s, 0)]);
  EXPECT_GT(check(s).count(MeshFailure::BadFacet), 0U);
}

TEST(Verify, FindsATetThatIsThereTwiceWhicheverWayItIsTurned) {
  for (const bool turned : {false, true}) {
    SolidFixture s = make_box({1, 1, 1}, 5, 2);
    Tet again = s.mesh.tets[inner_tet(s, 0)];
    if (turned) std::swap(again[1], again[3]);
    s.mesh.tets.push_back(again);
    const Verification v = check(s);
    ASSERT_EQ(v.count(MeshFailure::RepeatedTet), 1U);
    EXPECT_EQ(first(v, MeshFailure::RepeatedTet)->entity,
              static_cast<std::int32_t>(s.mesh.tets.size()) - 1);
  }
}

TEST(Verify, FindsTetsOutsideOfTheMaterial) {
  // A mesh of the whole box for a model that has a notch in one corner.
  const SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const auto notched = [](const Vec3& p) { return p.x < 0.5 || p.y < 0.5 || p.z < 0.5; };
  const Verification v =
      verify(s.mesh, s.supports, s.boundary, s.volume, {}, {.material = notched});
  EXPECT_GT(v.count(MeshFailure::OutsideTet), 10U);
  ASSERT_NE(first(v, MeshFailure::OutsideTet), nullptr);
  EXPECT_FALSE(notched(first(v, MeshFailure::OutsideTet)->place));
  EXPECT_TRUE(verify(s.mesh, s.supports, s.boundary, s.volume, {},
                     {.material = [](const Vec3& p) { return p.x > 0 && p.x < 1; }})
                  .valid);
}

TEST(Verify, FindsAnEdgeOfTheBoundaryInFourFacets) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  s.mesh.tets.erase(s.mesh.tets.begin() + static_cast<std::ptrdiff_t>(inner_tet(s, 2)));
  const Verification v = check(s);
  EXPECT_GT(v.count(MeshFailure::NonManifoldEdge), 0U);
  EXPECT_EQ(v.count(MeshFailure::BadFacet), 0U);
}

TEST(Verify, FindsANodeWhereACavityTouchesTheSurface) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const std::size_t t = inner_tet(s, 1);
  const Tet tet = s.mesh.tets[t];
  s.mesh.tets.erase(s.mesh.tets.begin() + static_cast<std::ptrdiff_t>(t));
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::NonManifoldVertex), 1U);
  EXPECT_EQ(v.count(MeshFailure::NonManifoldEdge), 0U);
  EXPECT_NE(std::find(tet.begin(), tet.end(), first(v, MeshFailure::NonManifoldVertex)->entity),
            tet.end());
}

TEST(Verify, FindsAMissingModelVertexAtItsPlace) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const std::int32_t node = find_node(s, Support::Kind::Vertex);
  const int vertex = s.supports[node].entity;
  s.supports[node] = {Support::Kind::Edge, s.boundary.vertices[vertex].edges[0]};
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::MissingVertex), 1U);
  EXPECT_EQ(first(v, MeshFailure::MissingVertex)->entity, vertex);
  EXPECT_EQ(first(v, MeshFailure::MissingVertex)->place, s.boundary.vertices[vertex].position);
}

TEST(Verify, FindsAModelEdgeThatIsNoChainOfMeshEdges) {
  // Two nodes of a straight edge change their names, so the chain runs from one to the next but
  // one.
  SolidFixture s = make_box({1, 1, 1}, 6, 2);
  const std::int32_t node = find_node(s, Support::Kind::Edge);
  const int edge = s.supports[node].entity;
  s.supports[node] = {Support::Kind::Face, s.boundary.edges[edge].faces[0]};
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::MissingSegment), 1U) << report(v);
  EXPECT_EQ(first(v, MeshFailure::MissingSegment)->entity, edge);
  EXPECT_LT(distance(first(v, MeshFailure::MissingSegment)->place, s.mesh.nodes[node]), 0.2);
}

TEST(Verify, FindsAClosedModelEdgeThatIsBroken) {
  SolidFixture s = make_cylinder(10, 8, 48, 1);
  s.supports[find_node(s, Support::Kind::Edge)] = {Support::Kind::Face, 0};
  EXPECT_EQ(check(s).count(MeshFailure::MissingSegment), 1U);
}

TEST(Verify, FindsAModelEdgeWithoutNodes) {
  SolidFixture s = make_cylinder(10, 8, 48, 1);
  for (Support& support : s.supports)
    if (support == Support{Support::Kind::Edge, 1}) support = {Support::Kind::Face, 2};
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::MissingSegment), 1U);
  EXPECT_EQ(first(v, MeshFailure::MissingSegment)->entity, 1);
}

TEST(Verify, FindsAnOrphanNode) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const std::int32_t node = s.add({0.5, 0.5, 0.5}, Support::Kind::Interior, -1);
  const Verification v = check(s);
  ASSERT_EQ(v.failures.size(), 1U) << report(v);
  EXPECT_EQ(v.failures[0].kind, MeshFailure::OrphanNode);
  EXPECT_EQ(v.failures[0].entity, node);
}

TEST(Verify, FindsABoundaryNodeThatLeftItsFace) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const std::int32_t node = find_node(s, Support::Kind::Face);
  s.mesh.nodes[node] += 1e-4 * Vec3{1, 1, 1};
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::NodeOffSupport), 1U);
  EXPECT_EQ(first(v, MeshFailure::NodeOffSupport)->entity, node);
}

TEST(Verify, FindsBoundaryFacetsThatLieOnNoCommonFace) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  s.supports[find_node(s, Support::Kind::Face)] = {};
  EXPECT_GE(check(s).count(MeshFailure::NonconformingFacet), 3U);
}

TEST(Verify, FindsAFacetThatIsTurnedOverOnItsFace) {
  // The cap of a cylinder in whose place its model has one that looks the other way.
  SolidFixture s = make_cylinder(10, 8, 24, 1);
  s.boundary.faces[2].reversed = true;
  EXPECT_GT(check(s).count(MeshFailure::NonconformingFacet), 20U);
}

/// A cylinder of radius 10 with four nodes round each circle; every tet stands on the wall.
SolidFixture four_sided_cylinder(double height = 2) {
  SolidFixture s = make_cylinder(10, height, 24, 1);
  s.mesh = {};
  s.supports.clear();
  for (int top = 0; top < 2; ++top)
    for (const Vec3& p : {Vec3{10, 0, 0}, Vec3{0, 10, 0}, Vec3{-10, 0, 0}, Vec3{0, -10, 0}})
      s.add(p + Vec3{0, 0, top * height}, Support::Kind::Edge, top);
  for (const auto& [x, y, z] : {std::array{0, 1, 2}, std::array{0, 3, 2}})  // prisms of three tets
    for (Tet t : {Tet{x, y, z, z + 4}, Tet{x, y, z + 4, y + 4}, Tet{x, x + 4, y + 4, z + 4}}) {
      const auto& p = s.mesh.nodes;
      if (tet_volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < 0) std::swap(t[0], t[1]);
      s.mesh.tets.push_back(t);
    }
  return s;
}

TEST(Verify, AllowsAsFewNodesRoundACircleAsCloseIt) {
  const SolidFixture s = four_sided_cylinder();
  const Verification v =
      verify(s.mesh, s.supports, s.boundary, s.volume, {}, {.volume_tolerance = 0.02});
  EXPECT_TRUE(v.valid) << report(v);
  EXPECT_NEAR(v.chord_error, 10 * (1 - std::sqrt(0.5)), 1e-9);
}

TEST(Verify, FindsAClosedModelEdgeOfTwoNodes) {
  // There and back again along a diagonal of the top: a slit, no circle.
  SolidFixture s = four_sided_cylinder();
  for (const std::int32_t n : {5, 7}) s.supports[n] = {Support::Kind::Face, 0};
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::MissingSegment), 1U) << report(v);
  EXPECT_EQ(first(v, MeshFailure::MissingSegment)->entity, 1);
}

TEST(Verify, AllowsATetOnAWallToBeOutsideAsFarAsChordsMayBe) {
  // The cylinder as a hole: what a tet with all nodes on its wall may hide of it.
  SolidFixture s = four_sided_cylinder();
  const auto outside_tets = [&](const Tet& tet) {
    s.mesh.tets = {tet};
    return verify(s.mesh, s.supports, s.boundary, s.volume, {},
                  {.material = [](const Vec3& p) { return std::hypot(p.x, p.y) > 10.001; }})
        .count(MeshFailure::OutsideTet);
  };
  EXPECT_EQ(outside_tets({0, 1, 2, 6}), 0U) << "centroid 6.5 off the wall, edges of 20.1";
  EXPECT_EQ(outside_tets({0, 2, 5, 7}), 1U) << "centroid on the axis, edges of 20";
}

TEST(Verify, FindsFacetsThatRunStraightAcrossACurvedFace) {
  // One half of the cylinder: its cut has nodes of the wall only.
  SolidFixture s = four_sided_cylinder();
  s.mesh.tets.resize(3);
  const Verification v = check(s);
  ASSERT_EQ(v.count(MeshFailure::FacetOffFace), 2U) << report(v);
  EXPECT_NEAR(first(v, MeshFailure::FacetOffFace)->place.y, 0, 1e-12);
  EXPECT_NEAR(v.chord_error, 10, 1e-9);
}

TEST(Verify, FindsFacetsAcrossAFaceHoweverLongTheyAre) {
  // A pin whose facets are much longer than it is thick, cut through: .05 of their length off it.
  SolidFixture s = four_sided_cylinder(200);
  EXPECT_EQ(check(s).count(MeshFailure::FacetOffFace), 0U);
  s.mesh.tets.resize(3);
  EXPECT_EQ(check(s).count(MeshFailure::FacetOffFace), 2U);
}

TEST(Verify, FindsAModelFaceThatIsNotCovered) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  s.boundary.faces[3].area *= 1.001;
  const Verification v = check(s);
  ASSERT_EQ(v.failures.size(), 1U) << report(v);
  EXPECT_EQ(v.failures[0].kind, MeshFailure::FaceArea);
  EXPECT_EQ(v.failures[0].entity, 3);
}

TEST(Verify, AllowsCurvedFacesTheirChordErrorAndNoMore) {
  SolidFixture s = make_cylinder(10, 8, 48, 1);
  ASSERT_EQ(check(s).count(MeshFailure::FaceArea), 0U);
  s.boundary.faces[0].area *= 1.03;
  EXPECT_EQ(check(s).count(MeshFailure::FaceArea), 1U);
}

TEST(Verify, FindsAVolumeThatIsOffByMoreThanTheTolerance) {
  const SolidFixture s = make_box({1, 1, 1}, 5, 2);
  EXPECT_TRUE(verify(s.mesh, s.supports, s.boundary, 1.0019, {}).valid);
  EXPECT_EQ(verify(s.mesh, s.supports, s.boundary, 1.0021, {}).count(MeshFailure::Volume), 1U);
  EXPECT_EQ(verify(s.mesh, s.supports, s.boundary, 1.0021, {}, {.volume_tolerance = 0.01})
                .count(MeshFailure::Volume),
            0U);
}

TEST(Verify, AcceptsACoarseCylinderWhoseChordsCutOffMoreThanTheTolerance) {
  const SolidFixture s = make_cylinder(10, 20, 14, 3);
  const Verification v = check(s);
  EXPECT_TRUE(v.valid) << report(v);
  EXPECT_LT(v.volume, 0.99 * s.volume);
  EXPECT_NEAR(v.volume + v.chord_volume, s.volume, 0.001 * s.volume);
  EXPECT_FALSE(verify(s.mesh, s.supports, s.boundary, 1.003 * s.volume, {}).valid);
}

TEST(Verify, FindsEverythingMissingInAnEmptyMesh) {
  const SolidFixture s = make_box({1, 1, 1}, 5, 2);
  const Verification v = verify(TetMesh{}, {}, s.boundary, s.volume, {});
  EXPECT_EQ(v.count(MeshFailure::MissingVertex), 8U);
  EXPECT_EQ(v.count(MeshFailure::MissingSegment), 12U);
  EXPECT_EQ(v.count(MeshFailure::FaceArea), 6U);
  EXPECT_EQ(v.count(MeshFailure::Volume), 1U);
}

TEST(Verify, KeepsTwentyDefectsOfAKindAndCountsTheRest) {
  SolidFixture s = make_box({1, 1, 1}, 5, 2);
  for (Tet& tet : s.mesh.tets) std::swap(tet[0], tet[1]);
  const Verification v = check(s);
  EXPECT_EQ(v.count(MeshFailure::BadTet), s.mesh.tets.size());
  EXPECT_EQ(std::count_if(v.failures.begin(), v.failures.end(),
                          [](const MeshDefect& f) { return f.kind == MeshFailure::BadTet; }),
            20);
}

}  // namespace
}  // namespace remeshd
