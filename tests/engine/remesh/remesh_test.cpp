#include "engine/remesh/remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "engine/base/error.h"
#include "engine/patch/tet_index.h"
#include "engine/revision/delaunay_state.h"
#include "engine/verify/verify.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

constexpr MeshOptions kSmall{.nodes = 2500, .iterations = 5};
constexpr MeshOptions kInherit{.iterations = 5};

Revision first(const std::string& name, const MeshOptions& options = kSmall) {
  return make_revision(Revision::none(), test::case_model(name), options, kRun);
}

Revision edit(const Revision& original, const ModelEdit& change,
              const MeshOptions& options = kInherit) {
  return make_revision(original, apply(original.source, change), options, kRun);
}

Revision edit(const Revision& original, const std::string& name) {
  return edit(original, test::case_edit(name));
}

void expect_valid(const Revision& r) {
  const Verification v =
      verify(r.output.mesh, r.delaunay_state->supports, r.cells.boundary, r.cells.volume, kRun);
  EXPECT_TRUE(v.valid) << (v.failures.empty() ? "" : v.failures.front().what);
}

class SevenCases : public testing::TestWithParam<test::EditCase> {};

TEST_P(SevenCases, GiveValidMeshesThatKeepMostOfTheOriginal) {
  const test::EditCase& c = GetParam();
  const Revision original = first(c.original);
  expect_valid(original);
  EXPECT_EQ(original.report.free_share, 1);
  EXPECT_EQ(original.report.counts.nodes_kept, 0U);
  EXPECT_NEAR(original.output.mesh.nodes.size(), 2500, 0.03 * 2500);
  EXPECT_NEAR(original.cells.volume, c.original_volume, 1e-6 * c.original_volume);
  const Revision remesh = edit(original, c.edit);
  expect_valid(remesh);
  EXPECT_NEAR(remesh.cells.volume, c.modified_volume, 1e-6 * c.modified_volume);
  EXPECT_NEAR(remesh.report.volume, c.modified_volume, 0.01 * c.modified_volume);
  const double kept =
      static_cast<double>(remesh.report.counts.nodes_kept) / remesh.report.counts.nodes;
  EXPECT_GT(kept, c.edit == "tool3-ab" ? 0.1 : 0.5);
  for (const Revision* r : {&original, &remesh}) {
    const Counts& counts = r->report.counts;
    EXPECT_EQ(counts.nodes_kept + counts.nodes_moved + counts.nodes_new, counts.nodes);
  }
  EXPECT_LT(remesh.report.free_share, 1.0);
  EXPECT_GT(remesh.report.quality.dihedral_min, 15);
}

INSTANTIATE_TEST_SUITE_P(Remesh, SevenCases, testing::ValuesIn(test::seven_cases()),
                         [](const auto& param) {
                           std::string name = param.param.edit;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Remesh, AKeptNodeIsItsOriginalUnderTheTransformationToTheBit) {
  const Revision original = first("simple-a"), remesh = edit(original, "simple-ab");
  const NodeMap& map = remesh.output.map;
  std::set<std::int32_t> transforms;
  for (std::size_t n = 0; n < map.node_origin.size(); ++n) {
    const std::int32_t o = map.original_node[n];
    if (map.node_origin[n] == NodeOrigin::New) {
      EXPECT_EQ(o, -1);
      continue;
    }
    const Vec3 copied = map.transforms[map.node_transform[n]].apply(original.output.mesh.nodes[o]);
    EXPECT_EQ(remesh.output.mesh.nodes[n] == copied, map.node_origin[n] == NodeOrigin::Kept);
    transforms.insert(map.node_transform[n]);
  }
  EXPECT_EQ(transforms.size(), 2U);  // the base stayed, the top moved
}

TEST(Remesh, AKeptTetStoodInTheOriginal) {
  const Revision original = first("tool1-a"), remesh = edit(original, "tool1-ac");
  const NodeMap& map = remesh.output.map;
  int kept = 0;
  for (std::size_t k = 0; k < map.original_tet.size(); ++k) {
    if (map.original_tet[k] < 0) continue;
    ++kept;
    const SortedNodes then = sorted_nodes(original.output.mesh.tets[map.original_tet[k]]);
    Tet now{};
    for (int i = 0; i < 4; ++i) {
      const std::int32_t n = remesh.output.mesh.tets[k][i];
      EXPECT_EQ(map.node_origin[n], NodeOrigin::Kept);
      now[i] = map.original_node[n];
    }
    ASSERT_EQ(sorted_nodes(now), then);
  }
  EXPECT_EQ(kept, static_cast<int>(remesh.report.counts.tets_kept));
  EXPECT_GT(kept, 0.4 * map.original_tet.size());
}

TEST(Remesh, PermanentIdsSurviveEditsAndAreNeverUsedTwice) {
  const Revision a = first("tool2-a");
  const Revision b = edit(a, "tool2-ab");
  const Revision c = edit(b, "tool2-bc");
  std::set<std::uint64_t> seen(a.output.node_ids.begin(), a.output.node_ids.end());
  EXPECT_EQ(seen.size(), a.output.node_ids.size());
  const Revision* parent = &a;
  for (const Revision* r : {&b, &c}) {
    std::set<std::uint64_t> own;
    for (std::size_t n = 0; n < r->output.node_ids.size(); ++n) {
      const std::uint64_t id = r->output.node_ids[n];
      EXPECT_TRUE(own.insert(id).second);
      const std::int32_t o = r->output.map.original_node[n];
      if (o >= 0)
        EXPECT_EQ(id, parent->output.node_ids[o]);
      else
        EXPECT_TRUE(seen.insert(id).second);
    }
    parent = r;
  }
}

TEST(Remesh, TheSameRequestGivesTheSameBytes) {
  const Revision original = first("tool1-a");
  EXPECT_EQ(test::stored_bytes(original), test::stored_bytes(first("tool1-a")));
  EXPECT_EQ(test::stored_bytes(edit(original, "tool1-ab")),
            test::stored_bytes(edit(original, "tool1-ab")));
}

TEST(Remesh, AnotherSeedGivesAnotherMesh) {
  MeshOptions other = kSmall;
  other.seed = 2;
  EXPECT_NE(first("simple-a").output.mesh.nodes, first("simple-a", other).output.mesh.nodes);
}

TEST(Remesh, AStoredRevisionIsEditedLikeTheOneInMemory) {
  const Revision original = first("tool2-b");
  const Revision restored = test::stored_and_loaded(original);
  EXPECT_TRUE(test::stored_bytes(restored) == test::stored_bytes(original));
  EXPECT_EQ(test::stored_bytes(edit(original, "tool2-bc")),
            test::stored_bytes(edit(restored, "tool2-bc")));
}

TEST(Remesh, AStoredRevisionOfAChainIsEditedLikeTheOneInMemory) {
  for (const auto& [model, one, other] : {std::array{"tool2-a", "tool2-ab", "tool2-bc"},
                                          std::array{"tool2-b", "tool2-bc", "tool2-cd"}}) {
    const Revision middle = edit(first(model), one);
    const Revision restored = test::stored_and_loaded(middle);
    EXPECT_TRUE(test::stored_bytes(edit(middle, other)) ==
                test::stored_bytes(edit(restored, other)))
        << model;
  }
}

TEST(Remesh, WithoutAChangeEverythingIsKept) {
  const Revision original = first("fig11-a");
  const Revision same = edit(original, ModelEdit{{SetParameter{"rib_dx", 10.0}}});
  EXPECT_EQ(same.output.mesh.tets, original.output.mesh.tets);
  EXPECT_EQ(same.output.mesh.nodes, original.output.mesh.nodes);
  EXPECT_EQ(same.report.counts.nodes_kept, original.report.counts.nodes);
  EXPECT_EQ(same.report.counts.tets_kept, original.report.counts.tets);
}

TEST(Remesh, ARotatedFeatureTakesItsNodesWithIt) {
  // Fine enough that the rib has an inside that no expansion reaches.
  const Revision original = first("fig6-a", {.nodes = 9000, .iterations = 3});
  const double a = 30 * std::numbers::pi / 180;
  ModelEdit turn;
  turn.edits.emplace_back(SetPlacement{
      "rib",
      PlacementSource{
          {-20.0, 0.0, 10.0}, std::nullopt, std::array<Scalar, 3>{std::cos(a), std::sin(a), 0.0}}});
  const Revision remesh = edit(original, turn);
  expect_valid(remesh);
  const NodeMap& map = remesh.output.map;
  int turned = 0;
  for (std::size_t n = 0; n < map.node_origin.size(); ++n)
    turned +=
        map.node_origin[n] == NodeOrigin::Kept && map.transforms[map.node_transform[n]].m[1] != 0;
  EXPECT_GT(turned, 20);
}

TEST(Remesh, FeaturesComeAndGo) {
  const Revision original = first("tool3-a");
  const Revision without = edit(original, ModelEdit{{RemoveFeature{"pocket"}}});
  expect_valid(without);
  EXPECT_NEAR(without.cells.volume - original.cells.volume, 20 * 30 * 8, 1e-6);
  FeatureSource slot =
      test::feature("groove", "slot", {{"length", 40.0}, {"width", 8.0}, {"height", 5.0}});
  slot.nature = Nature::Subtractive;
  slot.placement.origin = {0.0, 0.0, 0.0};
  const Revision with = edit(without, ModelEdit{{AddFeature{slot, ""}}});
  expect_valid(with);
  EXPECT_LT(with.cells.volume, without.cells.volume);
}

TEST(Remesh, AModelFarSmallerThanTheEdgeLengthOfItsBaseIsMeshed) {
  const Revision large = first("simple-a", {.nodes = 60});
  const ModelSource tiny =
      test::model_of({test::block("plate", 4, 4, 2), test::placed(test::cylinder("hole", 1.1, 2),
                                                                  0.5, 0, 0, Nature::Subtractive)});
  ASSERT_GT(large.edge_length, 20);
  expect_valid(make_revision(large, tiny, {}, kRun));
}

TEST(Remesh, AChainOfSmallEditsNeitherThinsTheMeshOutNorClotsIt) {
  Revision r = first("fig11-a");
  const double density = r.output.mesh.nodes.size() / r.cells.volume;
  for (int k = 1; k <= 12; ++k)
    r = edit(r, ModelEdit{{SetParameter{"hole_radius", 8 + 0.3 * (k <= 6 ? k : 12 - k)}}});
  expect_valid(r);
  EXPECT_NEAR(r.output.mesh.nodes.size() / r.cells.volume, density, 0.03 * density);
}

TEST(Remesh, EveryFacetKnowsItsFacesAndEveryTetItsOwners) {
  const Revision r = first("tool1-a");
  const MeshGroups& g = r.output.groups;
  std::map<std::string, double> area;
  for (const MeshFacet& f : g.facets) {
    const auto& names = g.facet_groups[f.group];
    ASSERT_FALSE(names.empty());
    const auto& p = r.output.mesh.nodes;
    const double a =
        0.5 * norm(cross(p[f.nodes[1]] - p[f.nodes[0]], p[f.nodes[2]] - p[f.nodes[0]]));
    for (const std::string& name : names) area[name] += a;
    const Tet& t = r.output.mesh.tets[f.tet];
    for (const std::int32_t n : f.nodes) EXPECT_NE(std::find(t.begin(), t.end(), n), t.end());
  }
  EXPECT_NEAR(area["hole1.wall"], 2 * std::numbers::pi * 5 * 12, 8);
  EXPECT_NEAR(area["hub.top"], std::numbers::pi * (18 * 18 - 9 * 9), 30);
  EXPECT_GT(area["pin1.top"], 0);
  EXPECT_EQ(area.count("hub.bottom"), 0U);
  std::map<std::vector<std::string>, double> volume;
  for (std::size_t k = 0; k < r.output.mesh.tets.size(); ++k) {
    const Tet& t = r.output.mesh.tets[k];
    const auto& p = r.output.mesh.nodes;
    volume[g.cell_owners[g.tet_cell[k]]] += tet_volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
  }
  const double hub = std::numbers::pi * (18 * 18 - 9 * 9) * 25;
  EXPECT_NEAR((volume[{"hub"}]), hub, 0.03 * hub);
}

TEST(Remesh, CoincidentFacesGiveAFacetBothNames) {
  // Mounts reach through the base: their bottoms are no boundary; the wall's y faces continue the
  // base's.
  const Revision r = first("tool2-a");
  std::set<std::vector<std::string>> groups(r.output.groups.facet_groups.begin(),
                                            r.output.groups.facet_groups.end());
  EXPECT_TRUE(groups.count({"wall.y_min"}) == 1);
  EXPECT_TRUE(groups.count({"base.y_min"}) == 1);
  for (const auto& g : groups) EXPECT_LE(g.size(), 2U);
}

TEST(Remesh, GroupsThatShareAPlaneStandInTheReportWithTheirExactAreas) {
  const Revision r =
      first("tool2-a");  // the wall's side continues the base's: 12 x 60 above 120 x 12
  std::map<std::string, GroupArea> groups;
  for (const GroupArea& g : r.report.groups) groups[g.group] = g;
  ASSERT_TRUE(groups.contains("wall.y_min"));
  EXPECT_NEAR(groups["wall.y_min"].exact_area, 12 * 60, 1e-6);
  EXPECT_NEAR(groups["base.y_min"].exact_area, 120 * 12, 1e-6);
  const double both = groups["wall.y_min"].mesh_area + groups["base.y_min"].mesh_area;
  EXPECT_NEAR(both, 12 * 60 + 120 * 12, 1e-6);
  EXPECT_FALSE(groups.contains("mount1.wall"));
}

TEST(Remesh, AProfilePointNudgedOffALevelSideMakesAConeNextToAPlane) {
  const auto stepped = [](double height) {
    return test::one_feature(
        test::feature("r", "revolution",
                      {test::point(0.0, 0.0), test::point(20.0, 0.0), test::point(20.0, 10.0),
                       test::point(8.0, height), test::point(8.0, 20.0), test::point(0.0, 20.0)},
                      {}));
  };
  const Revision level = make_revision(Revision::none(), stepped(10), {.nodes = 1000}, kRun);
  const Revision nudged = make_revision(level, stepped(10 - 1e-5), {}, kRun);
  EXPECT_GT(nudged.report.counts.nodes_kept, 0.3 * nudged.report.counts.nodes);
  const Revision anew = make_revision(Revision::none(), stepped(10 - 1e-5), {.nodes = 1000}, kRun);
  EXPECT_EQ(anew.report.strategy, MeshStrategy::Local);
}

TEST(Remesh, AStopRequestEndsTheRunAsCancelled) {
  std::stop_source source;
  remeshd::Run run;
  run.stop = source.get_token();
  run.on_progress = [&](const Progress& p) {
    if (p.stage == "optimise" && p.iteration == 2) source.request_stop();
  };
  try {
    make_revision(Revision::none(), test::case_model("tool1-a"), kSmall, run);
    FAIL() << "it went on";
  } catch (const Error& e) {
    EXPECT_EQ(e.info().kind, ErrorKind::Cancelled);
  }
}

TEST(Remesh, ProgressNeverGoesBack) {
  remeshd::Run run;
  double last = 0;
  std::vector<std::string> stages;
  run.on_progress = [&](const Progress& p) {
    EXPECT_GE(p.fraction, last);
    last = p.fraction;
    if (stages.empty() || stages.back() != p.stage) stages.emplace_back(p.stage);
  };
  make_revision(Revision::none(), test::case_model("simple-a"), {.nodes = 500, .iterations = 3},
                run);
  EXPECT_EQ(stages, (std::vector<std::string>{"cells", "difference", "nodes", "optimise", "extract",
                                              "improve", "verify"}));
}

TEST(Remesh, OptionsOutOfRangeAreRefused) {
  for (const MeshOptions& bad : {MeshOptions{.nodes = 3}, MeshOptions{.size = 0.0},
                                 MeshOptions{.size = -1.0}, MeshOptions{.nodes = 100, .size = 1.0}})
    try {
      make_revision(Revision::none(), test::case_model("simple-a"), bad, kRun);
      ADD_FAILURE() << "accepted";
    } catch (const Error& e) {
      EXPECT_EQ(e.info().reason, "OPTIONS_INVALID");
    }
}

TEST(Remesh, TheControlMeshTellsInsideFromOutsideAsMembershipDoes) {
  MeshOptions control = kSmall;
  control.inside = MeshOptions::Inside::ControlMesh;
  const Revision original = first("tool3-a", control);
  expect_valid(original);
  MeshOptions correspond = kInherit;
  correspond.inside = control.inside;
  const Revision remesh = edit(original, test::case_edit("tool3-ab"), correspond);
  expect_valid(remesh);
  EXPECT_GT(remesh.report.counts.nodes_kept, 200U);
}

TEST(Remesh, AutoIterationsStopBeforeTheirLimit) {
  const Revision r = first("simple-a", {.nodes = 1500, .iterations = 0});
  EXPECT_GE(r.report.counts.iterations, 4U);
  EXPECT_LT(r.report.counts.iterations, 30U);
}

TEST(Remesh, AModelThatMovesFarAndLosesAFeatureIsMeshed) {
  // It leaves the parent's super vertices: the Delaunay mesh begins anew and has fewer tets.
  ModelSource model = test::one_feature(test::block("plate", 10, 10, 1));
  model.features.push_back(test::block("post", 3, 3, 20));
  const Revision original =
      make_revision(Revision::none(), model, {.nodes = 400, .iterations = 3}, kRun);
  model.features.pop_back();
  model.features[0].placement.origin = {1000.0, 0.0, 0.0};
  const Revision moved = make_revision(original, model, {.iterations = 3}, kRun);
  expect_valid(moved);
  EXPECT_EQ(moved.report.strategy, MeshStrategy::Local);
  EXPECT_GT(moved.report.counts.nodes_copied, 0U);
}

TEST(Remesh, ASharpWedgeIsRepairedWithFewNodes) {
  // Tets across the wedge's edge survived eight rounds of inserting nodes beside it.
  const Revision r = first("tool2-d", {.nodes = 15098, .iterations = 10, .seed = 4});
  expect_valid(r);
  EXPECT_NEAR(r.output.mesh.nodes.size(), 15098, 0.01 * 15098);
  for (const Warning& w : r.report.warnings)
    EXPECT_EQ(w.message.find("seed"), std::string::npos) << w.message;
}

}  // namespace
}  // namespace remeshd
