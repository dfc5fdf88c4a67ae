#include "tests/campaign/verifier/verifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/model/feature_model.h"
#include "tests/campaign/rays.h"
#include "tests/campaign/verifier/mesh_surface.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

/// A plate of 10 x 10 x 4 with a hole of radius `radius` through its middle.
ModelSource plate(double radius) {
  ModelSource model =
      test::one_feature(test::feature("plate", "block", {{"dx", 10.0}, {"dy", 10.0}, {"dz", 4.0}}));
  FeatureSource hole = test::feature("hole", "cylinder", {{"radius", radius}, {"height", 4.0}});
  hole.nature = Nature::Subtractive;
  model.features.push_back(hole);
  return model;
}

struct Meshes {
  Revision first, edited, morphed;
};

/// Of the plate and of edits of its hole, by much and by so little that the connectivity is kept.
const Meshes& meshes() {
  static const Meshes made = [] {
    Meshes m;
    m.first = make_revision(Revision::none(), plate(2), {.nodes = 700}, Run{});
    m.edited = make_revision(m.first, plate(2.2), {}, Run{});
    m.morphed = make_revision(m.first, plate(2.002), {}, Run{});
    return m;
  }();
  return made;
}

Findings verify_edited(const Revision& revision) {
  std::set<std::uint64_t> nodes, tets;
  return verify_independently(revision, &meshes().first, nodes, tets);
}

std::string list(const Findings& findings) {
  std::string text;
  for (const auto& [check, entry] : findings.entries()) text += check + ": " + entry.first + "\n";
  return text;
}

std::size_t some_node(const Revision& r, bool boundary) {
  std::vector<char> on(r.output.mesh.nodes.size(), 0);
  for (const MeshFacet& f : r.output.groups.facets)
    for (const std::int32_t n : f.nodes) on[n] = 1;
  for (std::size_t n = 0; n < on.size(); ++n)
    if ((on[n] == 1) == boundary && r.output.map.node_origin[n] == NodeOrigin::Kept) return n;
  return 0;
}

TEST(Verifier, FindsNothingInGoodMeshes) {
  std::set<std::uint64_t> nodes, tets;
  EXPECT_EQ(list(verify_independently(meshes().first, nullptr, nodes, tets)), "");
  for (const Revision* edited : {&meshes().edited, &meshes().morphed}) {
    std::set<std::uint64_t> nodes_then = nodes, tets_then = tets;
    EXPECT_EQ(list(verify_independently(*edited, &meshes().first, nodes_then, tets_then)), "");
  }
}

TEST(Verifier, FindsAnInvertedTet) {
  Revision r = meshes().edited;
  Tet& tet = r.output.mesh.tets.edit(7);
  std::swap(tet[0], tet[1]);
  EXPECT_TRUE(verify_edited(r).has("volume sign")) << list(verify_edited(r));
}

TEST(Verifier, FindsAFlatTet) {
  Findings findings;
  check_connectivity({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0}}, {{0, 1, 2, 3}}}, findings);
  EXPECT_TRUE(findings.has("volume sign"));
}

TEST(Verifier, FindsARepeatedTet) {
  Revision r = meshes().edited;
  r.output.mesh.tets.edit(8) = r.output.mesh.tets[7];
  EXPECT_TRUE(verify_edited(r).has("repeated tet")) << list(verify_edited(r));
}

TEST(Verifier, FindsAMissingTet) {
  Revision r = meshes().edited;
  const std::size_t tets = r.output.mesh.tets.size() - 1;
  r.output.mesh.tets.resize(tets);
  r.output.tet_ids.resize(tets);
  r.output.map.original_tet.resize(tets);
  r.output.groups.tet_cell.resize(tets);
  EXPECT_TRUE(verify_edited(r).has("facets")) << list(verify_edited(r));
}

TEST(Verifier, FindsAnOrphanNode) {
  Findings findings;
  check_connectivity({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}, {{0, 1, 2, 3}}},
                     findings);
  EXPECT_TRUE(findings.has("orphan node"));
}

TEST(Verifier, FindsTetsThatMeetAtANodeOnly) {
  Findings findings;
  check_connectivity(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
       {{0, 1, 2, 3}, {0, 4, 6, 5}}},
      findings);
  EXPECT_TRUE(findings.has("connected")) << list(findings);
  EXPECT_TRUE(findings.has("manifold node")) << list(findings);
}

TEST(Verifier, FindsTetsThatMeetAlongAnEdgeOnly) {
  Findings findings;
  check_connectivity({{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                      {{0, 2, 3, 1}, {0, 4, 5, 1}}},
                     findings);
  EXPECT_TRUE(findings.has("closed boundary")) << list(findings);
}

TEST(Verifier, FindsTwoTetsOnOneSideOfAFacet) {
  Findings findings;
  check_connectivity(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 2}}, {{0, 1, 2, 3}, {0, 1, 2, 4}}},
      findings);
  EXPECT_TRUE(findings.has("facet")) << list(findings);
}

TEST(Verifier, FindsABoundaryNodeOffItsSurface) {
  Revision r = meshes().edited;
  r.output.mesh.nodes.edit(some_node(r, true)) += Vec3{1e-3, 1e-3, 1e-3};
  EXPECT_TRUE(verify_edited(r).has("node on surface")) << list(verify_edited(r));
}

TEST(Verifier, FindsAKeptNodeThatMovedByABit) {
  Revision r = meshes().edited;
  double& x = r.output.mesh.nodes.edit(some_node(r, false)).x;
  x = std::nextafter(x, 100);
  EXPECT_TRUE(verify_edited(r).has("kept node")) << list(verify_edited(r));
}

TEST(Verifier, FindsFacetsUnderTheNameOfAnotherFace) {
  Revision r = meshes().edited;
  std::int32_t& group = r.output.groups.facets[3].group;
  group = (group + 1) % static_cast<std::int32_t>(r.output.groups.facet_groups.size());
  EXPECT_TRUE(verify_edited(r).has("names")) << list(verify_edited(r));
}

TEST(Verifier, FindsATetInTheWrongCell) {
  Revision r = meshes().edited;
  r.output.groups.cell_owners.push_back({"plate", "hole"});
  r.output.groups.tet_cell.edit(5) =
      static_cast<std::int32_t>(r.output.groups.cell_owners.size()) - 1;
  EXPECT_TRUE(verify_edited(r).has("owners")) << list(verify_edited(r));
}

TEST(Verifier, FindsAnIdThatIsUsedTwice) {
  Revision r = meshes().edited;
  r.output.node_ids.edit(0) = r.output.node_ids[1];
  r.output.tet_ids.edit(0) = r.output.tet_ids[1];
  EXPECT_TRUE(verify_edited(r).has("node ids")) << list(verify_edited(r));
  EXPECT_TRUE(verify_edited(r).has("tet ids")) << list(verify_edited(r));
}

TEST(Verifier, FindsAnIdThatAnAncestorHad) {
  std::set<std::uint64_t> nodes;
  std::set<std::uint64_t> tets{meshes().edited.output.tet_ids.begin(),
                               meshes().edited.output.tet_ids.end()};
  const Findings findings = verify_independently(meshes().edited, &meshes().first, nodes, tets);
  EXPECT_TRUE(findings.has("tet ids")) << list(findings);
}

/// The first id of some that others have not.
std::uint64_t lost(const CowVector<std::uint64_t>& before, const CowVector<std::uint64_t>& now) {
  const std::set<std::uint64_t> there(now.begin(), now.end());
  return *std::ranges::find_if(before, [&](std::uint64_t id) { return !there.contains(id); });
}

TEST(Verifier, FindsANewNodeWithAnIdThatTheBaseHad) {
  Revision r = meshes().edited;
  OutputMesh& mesh = r.output;
  std::size_t node = 0;
  while (mesh.map.node_origin[node] != NodeOrigin::New) ++node;
  mesh.node_ids.edit(node) = lost(meshes().first.output.node_ids, mesh.node_ids);
  EXPECT_EQ(list(verify_edited(r)),
            "node ids: a new one with an id that an earlier mesh of the chain had\n");
}

constexpr const char* kOldTetId =
    "tet ids: a new one with an id that an earlier mesh of the chain had\n";

TEST(Verifier, FindsANewTetWithAnIdThatTheBaseHad) {
  Revision r = meshes().edited;
  OutputMesh& mesh = r.output;
  std::size_t tet = 0;
  while (mesh.map.original_tet[tet] >= 0) ++tet;
  mesh.tet_ids.edit(tet) = lost(meshes().first.output.tet_ids, mesh.tet_ids);
  EXPECT_EQ(list(verify_edited(r)), kOldTetId);
}

TEST(Verifier, AllowsADeformedTetTheIdThatItHadAndNoOther) {
  Revision r = meshes().morphed;
  ASSERT_EQ(r.report.strategy, MeshStrategy::Morphed);
  CowVector<std::uint64_t>& ids = r.output.tet_ids;
  const CowVector<std::int32_t>& original = r.output.map.original_tet;
  ASSERT_GT(std::ranges::count(original.flat(), -1), 10);
  std::size_t a = 0;
  while (original[a] >= 0) ++a;
  std::size_t b = a + 1;
  while (original[b] >= 0) ++b;
  ASSERT_EQ(ids[a], meshes().first.output.tet_ids[a]);
  std::swap(ids.edit(a), ids.edit(b));
  EXPECT_EQ(list(verify_edited(r)), kOldTetId);
}

TEST(Verifier, FindsATetThatIsToldAsNewThoughNothingOfItMoved) {
  Revision r = meshes().morphed;
  CowVector<std::int32_t>& original = r.output.map.original_tet;
  std::size_t kept = 0;
  while (original[kept] < 0) ++kept;
  original.edit(kept) = -1;
  EXPECT_EQ(list(verify_edited(r)), kOldTetId);
}

TEST(Verifier, FindsAKeptTetOfOtherNodes) {
  Revision r = meshes().edited;
  CowVector<std::int32_t>& from = r.output.map.original_tet;
  std::size_t a = 0;
  while (from[a] < 0) ++a;
  std::size_t b = a + 1;
  while (from[b] < 0) ++b;
  std::swap(from.edit(a), from.edit(b));
  EXPECT_TRUE(verify_edited(r).has("tet map")) << list(verify_edited(r));
}

TEST(Verifier, FindsAMeshThatLacksAHole) {
  Revision r = meshes().first;
  r.model = evaluate([] {
    ModelSource two = plate(2);
    FeatureSource small = test::feature("small", "cylinder", {{"radius", 0.8}, {"height", 4.0}});
    small.nature = Nature::Subtractive;
    small.placement.origin = {3.5, 3.5, 0.0};
    two.features.push_back(small);
    return two;
  }());
  std::set<std::uint64_t> nodes, tets;
  const Findings findings = verify_independently(r, nullptr, nodes, tets);
  for (const char* check : {"coverage", "inside", "centroid", "exact volume"})
    EXPECT_TRUE(findings.has(check)) << check << "\n" << list(findings);
}

TEST(Verifier, FindsABoundaryInsideOfTheMaterial) {
  Revision r = meshes().first;
  r.model = evaluate([] {
    ModelSource two = plate(2);
    FeatureSource boss = test::feature("boss", "block", {{"dx", 2.4}, {"dy", 9.0}, {"dz", 2.0}});
    boss.placement.origin = {3.6, 0.0, 4.0};
    two.features.push_back(boss);
    return two;
  }());
  std::set<std::uint64_t> nodes, tets;
  const Findings findings = verify_independently(r, nullptr, nodes, tets);
  for (const char* check : {"node on boundary", "facet place"})
    EXPECT_TRUE(findings.has(check)) << check << "\n" << list(findings);
}

// The plane below is nearer to the wall's points than the wall's own coarse facets.
TEST(Verifier, ForgivesAWallsChordsBesideAPlane) {
  ModelSource model =
      test::one_feature(test::feature("disc", "cylinder", {{"radius", 100.0}, {"height", 34.0}}));
  FeatureSource hole = test::feature("hole", "cylinder", {{"radius", 8.9}, {"height", 34.0}});
  hole.nature = Nature::Subtractive;
  hole.placement.origin = {70.0, 11.0, 4.7e-4};  // a film is left below
  model.features.push_back(hole);
  const Revision r =
      make_revision(Revision::none(), model, {.nodes = 300, .seed = 662}, remeshd::Run{});
  std::set<std::uint64_t> nodes, tets;
  EXPECT_EQ(list(verify_independently(r, nullptr, nodes, tets)), "");
}

// A gap of 1e-4 rad opens between the block's top and the cylinder's bottom: where it begins, no
// direction at a fair angle to them leads out of the material.
TEST(Verifier, FindsTheAirInAGapOfATinyAngle) {
  ModelSource model = test::one_feature(
      test::feature("plate", "block", {{"dx", 375.75636}, {"dy", 265.03945}, {"dz", 38.102921}}));
  PlacementSource& plate = model.features[0].placement;
  plate.x_axis = {{-0.3047171438789854, -0.8464596929487336, -0.43663881004712535}};
  plate.z_axis = {{-0.7901560920775541, 0.4806338921097069, -0.38032145864807915}};
  FeatureSource pocket =
      test::feature("pocket", "block", {{"dx", 17.0}, {"dy", 20.0}, {"dz", 22.0}});
  pocket.nature = Nature::Subtractive;
  pocket.placement = {{16.0, 130.0, 86.0},
                      plate.z_axis,
                      {{0.18131257077825977, 0.7760511746200663, 0.604044970220425}}};
  model.features.push_back(pocket);
  FeatureSource peg =
      test::feature("peg", "cylinder", {{"radius", 14.255922}, {"height", 42.11087}});
  peg.placement.origin = {-22.501555, -0.12063199, -53.589299};
  peg.placement.x_axis = {{-0.30461862419233143, -0.8465196122025773, -0.436591387857765}};
  peg.placement.z_axis = {{-0.7901940783226674, 0.4805283510759669, -0.3803758961816624}};
  model.features.push_back(peg);
  const Revision r =
      make_revision(Revision::none(), model, {.nodes = 300, .seed = 557}, remeshd::Run{});
  std::set<std::uint64_t> nodes, tets;
  EXPECT_EQ(list(verify_independently(r, nullptr, nodes, tets)), "");
}

TEST(Verifier, FindsAWrongVolumeInTheReport) {
  Revision r = meshes().edited;
  r.report.volume *= 1.001;
  r.report.exact_volume *= 1.1;
  const Findings findings = verify_edited(r);
  for (const char* check : {"volume", "exact volume", "reported volume"})
    EXPECT_TRUE(findings.has(check)) << check << "\n" << list(findings);
}

// A sphere that rises .01 above a plate: the chord of the circle where it leaves the plate is much
// farther off that circle than off the sphere.
TEST(MeshSurface, TellsHowFarAChordIsOffTheCurveWhereTwoFacesMeet) {
  ModelSource model =
      test::one_feature(test::feature("plate", "block", {{"dx", 4.0}, {"dy", 4.0}, {"dz", 1.0}}));
  FeatureSource ball = test::feature("ball", "sphere", {{"radius", 1.0}});
  ball.placement.origin = {0.0, 0.0, 0.01};
  model.features.push_back(ball);
  const Membership membership(evaluate(model));
  ASSERT_FALSE(membership.inside({0.0, 0.0, 1.02}));
  ASSERT_TRUE(membership.inside({0.0, 0.0, 1.005}));
  const double r = std::sqrt(1 - 0.99 * 0.99), half = 0.5 * r, in = std::sqrt(r * r - half * half);
  const TetMesh mesh{{{in, -half, 1}, {in, half, 1}, {0, 0, 1.01}}, {}};
  const std::vector<Triangle> facets{{0, 1, 2}};
  const MeshSurface surface(mesh, facets, membership, 1e-6);
  EXPECT_NEAR(surface.rim_rise(0), r - in, 1e-6);
  EXPECT_GT(surface.rim_rise(0), 2 * surface.allowed(0));
}

TEST(Rays, FindTheBoundaryWithinReachOnly) {
  const Membership membership(evaluate(plate(2)));
  const Rays rays(membership);
  const Vec3 in_the_hole{1.9, 0, 2};
  EXPECT_TRUE(rays.boundary_within(in_the_hole, 0.15));
  EXPECT_FALSE(rays.boundary_within(in_the_hole, 0.09));
}

}  // namespace
}  // namespace remeshd::campaign
