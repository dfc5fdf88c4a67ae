// First meshes and edits of models with groups: rims that stay edges, members, areas, policies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// A plate with a hole and beside it a rib that ends in the plane of its top.
ModelSource plate_and_rib(std::vector<GroupSource> groups, double hole_x = -8) {
  ModelSource source = test::model_of(
      {test::block("plate", 40, 30, 8), test::placed(test::block("rib", 12, 6, 8), 22, 0, 0),
       test::placed(test::cylinder("hole", 4, 10), hole_x, 0, -1, Nature::Subtractive)});
  source.groups = std::move(groups);
  return source;
}

Revision first_mesh(const ModelSource& source) {
  return make_revision(Revision::none(), source, {.nodes = 600}, kRun);
}
Revision edited(const Revision& base, const ModelEdit& edit) {
  return make_revision(base, apply(base.source, edit), {}, kRun);
}

const GroupMembers& members_of(const Revision& r, const std::string& group) {
  const auto found = std::ranges::find(r.output.groups.of_model, group, &GroupMembers::name);
  if (found == r.output.groups.of_model.end()) throw std::out_of_range(group);
  return *found;
}
GroupFigures figures_of(const Revision& r, const std::string& group) {
  for (const GroupFigures& figures : r.report.figures)
    if (figures.group == group) return figures;
  throw std::out_of_range(group);
}
/// The place of the error that a model's groups are before there is a mesh; empty: none.
std::string refused_before_meshing(const Revision& parent, const ModelSource& source) {
  const FeatureModel model = evaluate(source);
  const CellularModel cells = build_cells(model, kRun);
  try {
    check_groups(parent, model, cells.boundary, kRun);
  } catch (const Error& why) {
    return test::place_of(why.info());
  }
  return "";
}
ModelEdit move_hole(double x) { return {{SetPlacement{"hole", {.origin = {x, 0.0, -1.0}}}}}; }

bool has_warning(const Revision& r, const std::string& group) {
  return std::ranges::any_of(r.report.warnings, [&](const Warning& w) {
    return w.code == WarningCode::GroupEmptied && w.groups == std::vector<std::string>{group};
  });
}

TEST(GroupsOfAModel, HaveTheFacetsOfTheirFacesToTheRim) {
  const Revision r = first_mesh(plate_and_rib({{"load", "rib.top", {}}, {"bore", "hole", {}}}));
  // Of the rib's top 6 x 6 stick out of the plate, the rest is flush with the plate's own.
  const GroupFigures load = figures_of(r, "load");
  EXPECT_NEAR(load.mesh_area, 12 * 6, 1e-9);
  EXPECT_NEAR(*load.exact_area, 12 * 6, 1e-9);
  EXPECT_EQ(load.parts, 1U);
  EXPECT_EQ(load.tets, 0U);
  EXPECT_NEAR(norm(load.normal - Vec3{0, 0, 1}), 0, 1e-12);
  EXPECT_NEAR(norm(load.centroid - Vec3{22, 0, 8}), 0, 1e-9);
  const GroupFigures bore = figures_of(r, "bore");
  EXPECT_NEAR(*bore.exact_area, 2 * M_PI * 4 * 8, 1e-6);
  EXPECT_NEAR(bore.mesh_area, *bore.exact_area, 0.05 * *bore.exact_area);
}

TEST(GroupsOfAModel, HaveOfEachFaceWhatItsOwnConditionSelects) {
  const Revision r =
      first_mesh(plate_and_rib({{"load", "plate.top & y > 0 | rib.top & y < 0", {}}}));
  const double holes_half = 0.5 * M_PI * 4 * 4;
  const GroupFigures load = figures_of(r, "load");
  EXPECT_NEAR(*load.exact_area, 40 * 15 - holes_half + 12 * 3, 1);
  EXPECT_NEAR(load.mesh_area, *load.exact_area, 0.1 * *load.exact_area);
}

TEST(GroupsOfAModel, OfAHoleHaveNoMaterialOfWhatFillsIt) {
  ModelSource source = plate_and_rib({{"bore", "hole", {}}});
  source.features.push_back(test::placed(test::cylinder("pin", 2, 8), -8, 0, 0));
  source.features.push_back(test::placed(test::block("bridge", 12, 2, 2), -8, 0, 0));
  EXPECT_TRUE(members_of(first_mesh(source), "bore").tets.empty());
}

TEST(GroupsOfAModel, HaveTheMaterialOfFeaturesThatTheyNameAsAWhole) {
  const Revision r = first_mesh(plate_and_rib({{"arm", "rib", {}}, {"end", "rib & x > 25", {}}}));
  double arm = 0, end = 0;
  for (const std::int32_t t : members_of(r, "arm").tets)
    arm += tet_volume(r.output.mesh.nodes, r.output.mesh.tets[t]);
  for (const std::int32_t t : members_of(r, "end").tets) {
    end += tet_volume(r.output.mesh.nodes, r.output.mesh.tets[t]);
    EXPECT_GT(centroid(r.output.mesh.nodes, r.output.mesh.tets[t]).x, 25);
  }
  EXPECT_NEAR(arm, 12 * 6 * 8, 0.15 * 12 * 6 * 8);
  EXPECT_NEAR(end, 3 * 6 * 8, 0.4 * 3 * 6 * 8);
}

TEST(GroupsOfAModel, UnderAConditionTellTheExactAreaBesideTheFacets) {
  const Revision r = first_mesh(plate_and_rib({{"half", "plate.top & y > 1.7", {}}}));
  const GroupFigures half = figures_of(r, "half");
  // y > 1.7 of the plate, of the hole's circle what lies there left out.
  const double cut = 16 * std::acos(1.7 / 4) - 1.7 * std::sqrt(16 - 1.7 * 1.7);
  EXPECT_NEAR(*half.exact_area, 13.3 * 40 - cut, 0.05);
  EXPECT_NEAR(half.mesh_area, *half.exact_area, 0.1 * *half.exact_area);
  for (const std::int32_t f : members_of(r, "half").facets) {
    const auto& n = r.output.groups.facets[f].nodes;
    const auto& p = r.output.mesh.nodes;
    EXPECT_GT((p[n[0]].y + p[n[1]].y + p[n[2]].y) / 3, 1.7);
  }
}

TEST(GroupsOfAModel, KeepTheirAreaExactThroughEdits) {
  Revision r = first_mesh(plate_and_rib({{"load", "rib.top", {}}, {"bore", "hole.wall", {}}}));
  for (const double x : {-7.0, 9.0}) {
    r = edited(r, move_hole(x));
    EXPECT_NEAR(figures_of(r, "load").mesh_area, 12 * 6, 1e-9) << x;
    EXPECT_EQ(figures_of(r, "load").state, GroupState::Same) << x;
    EXPECT_EQ(figures_of(r, "bore").state, GroupState::Same) << x;
    EXPECT_GT(r.report.counts.nodes_kept, 0U);
  }
}

TEST(GroupsOfAModel, TellWhatBecameOfThem) {
  const Revision base = first_mesh(plate_and_rib(
      {{"load", "plate.top", {}}, {"bore", "hole.wall", {}}, {"side", "plate.x_max", {}}}));
  EXPECT_EQ(figures_of(base, "load").state, GroupState::Unspecified);
  const Revision wider = edited(base, {{SetFeatureParameter{"hole", "radius", Scalar(5.0)}}});
  EXPECT_EQ(figures_of(wider, "load").state, GroupState::Resized);
  EXPECT_EQ(figures_of(wider, "bore").state, GroupState::Resized);
  EXPECT_EQ(figures_of(wider, "side").state, GroupState::Same);
  const FeatureSource slot =
      test::placed(test::block("slot", 4, 40, 4), 8, 0, 6, Nature::Subtractive);
  const Revision cut = edited(base, {{AddFeature{slot, ""}}});
  EXPECT_EQ(figures_of(cut, "load").state, GroupState::Split);
  EXPECT_EQ(figures_of(edited(cut, {{RemoveFeature{"slot"}}}), "load").state, GroupState::Merged);
  const Revision more = edited(base, {{SetGroup{"new", "rib.top", {}}}});
  EXPECT_EQ(figures_of(more, "new").state, GroupState::New);
  const Revision closed = edited(base, {{RemoveFeature{"hole"}}});
  EXPECT_EQ(figures_of(closed, "bore").state, GroupState::Emptied);
  EXPECT_TRUE(has_warning(closed, "bore"));
  EXPECT_EQ(figures_of(closed, "hole.wall").state, GroupState::Emptied)
      << "a group of facets that the mesh has no more";
}

TEST(GroupsOfAModel, ThatComeAndGoChangeTheMeshAtTheirRimsAlone) {
  const Revision base = first_mesh(plate_and_rib({}));
  const Revision plain = edited(base, {{SetGroup{"side", "plate.x_min", {}}}});
  EXPECT_EQ(plain.report.strategy, MeshStrategy::Unchanged) << "no rim of it was not an edge";
  EXPECT_EQ(members_of(plain, "side").facets.empty(), false);
  const Revision rim = edited(plain, {{SetGroup{"load", "rib.top", {}}}});
  EXPECT_NEAR(figures_of(rim, "load").mesh_area, 12 * 6, 1e-9);
  EXPECT_GT(rim.report.counts.nodes_kept, 0.6 * rim.report.counts.nodes);
  const Revision gone = edited(rim, {{RemoveGroup{"load"}}});
  EXPECT_GT(gone.report.counts.nodes_kept, 0.6 * gone.report.counts.nodes);
  EXPECT_EQ(gone.output.groups.of_model.size(), 1U);
}

TEST(GroupsOfAModel, ThatSelectNothingAreAnErrorOfAFirstMesh) {
  for (const char* on : {"bore*.wall", "plate.top & z > 9", "rib & z > 9"}) {
    SCOPED_TRACE(on);
    const ModelSource source = plate_and_rib({{"a", on, {}}});
    const ErrorInfo info = test::error_of([&] { first_mesh(source); });
    EXPECT_EQ(test::place_of(info), "SELECTOR_EMPTY - groups.a.on");
    EXPECT_EQ(refused_before_meshing(Revision::none(), source), test::place_of(info));
  }
  EXPECT_EQ(refused_before_meshing(Revision::none(), plate_and_rib({{"a", "hole.wall", {}}})), "");
}

TEST(GroupsOfAModel, SmallerThanTheFacetsTellTheirArea) {
  const ErrorInfo info = test::error_of([] {
    first_mesh(plate_and_rib({{"load", "plate.top & x*x + y*y < .01", {}}}));
  });
  EXPECT_EQ(test::place_of(info), "SELECTOR_EMPTY - groups.load.on");
  EXPECT_NE(info.message.find("an area of 0.03"), std::string::npos) << info.message;
}

TEST(GroupsOfAModel, ThatAnEditEmptiesAreNoErrorBeforeMeshing) {
  const Revision base = first_mesh(plate_and_rib({{"bore", "hole.wall", {}}}));
  EXPECT_EQ(refused_before_meshing(base, apply(base.source, {{RemoveFeature{"hole"}}})), "");
}

TEST(GroupsOfAModel, FailAnEditByTheirPolicies) {
  const Revision base = first_mesh(plate_and_rib({{"load", "plate.top", {.max_area_change = 0.02}},
                                                  {"bore", "hole.wall", {.fail_emptied = true}}}));
  const auto refused = [&](const ModelEdit& edit) {
    const std::string place = test::place_of(test::error_of([&] { edited(base, edit); }));
    EXPECT_EQ(refused_before_meshing(base, apply(base.source, edit)), place);
    return place;
  };
  const ModelEdit slightly{{SetFeatureParameter{"hole", "radius", Scalar(4.3)}}};
  EXPECT_NO_THROW(edited(base, slightly));
  EXPECT_EQ(refused_before_meshing(base, apply(base.source, slightly)), "");
  EXPECT_EQ(refused({{SetFeatureParameter{"hole", "radius", Scalar(6.0)}}}),
            "POLICY_BROKEN - groups.load.policy.maxAreaChange");
  EXPECT_EQ(refused({{SetFeatureParameter{"hole", "radius", Scalar(1.0)}}}),
            "POLICY_BROKEN - groups.load.policy.maxAreaChange");
  EXPECT_EQ(refused({{SetGroup{"load", {}, GroupPolicy{}}, RemoveFeature{"hole"}}}),
            "POLICY_BROKEN - groups.bore.policy.onEmptied");
}

TEST(GroupsOfAModel, OfRoundFacesHaveTheirRimsInMeshes) {
  ModelSource source = test::model_of(
      {test::cylinder("shaft", 5, 20), test::placed(test::cylinder("end", 5, 10), 0, 0, 20)});
  source.groups = {{"seat", "end.wall", {}}};
  const Revision r = first_mesh(source);
  EXPECT_NEAR(*figures_of(r, "seat").exact_area, 2 * M_PI * 5 * 10, 1e-6);
  double lowest = HUGE_VAL;
  for (const std::int32_t f : members_of(r, "seat").facets)
    for (const std::int32_t n : r.output.groups.facets[f].nodes)
      lowest = std::fmin(lowest, r.output.mesh.nodes[n].z);
  EXPECT_NEAR(lowest, 20, 1e-9);
}

}  // namespace
}  // namespace remeshd
