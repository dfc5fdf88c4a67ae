#include "engine/patch/patch.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/patch/tet_index.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

Revision first(const std::string& name, std::uint32_t nodes) {
  return make_revision(Revision::none(), test::case_model(name), {.nodes = nodes, .iterations = 5},
                       kRun);
}

Revision edit(const Revision& original, const ModelEdit& change) {
  return make_revision(original, apply(original.source, change), {.iterations = 5}, kRun);
}

/// Every tet of a Delaunay state is a cell of the triangulation that CGAL makes of its nodes.
void expect_delaunay(const DelaunayState& delaunay_state) {
  using K = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Oracle = CGAL::Delaunay_triangulation_3<K>;
  Oracle oracle;
  std::vector<Oracle::Vertex_handle> at;
  for (const Vec3& p : delaunay_state.positions()) {
    at.push_back(oracle.insert(K::Point_3(p.x, p.y, p.z),
                               at.empty() ? Oracle::Cell_handle() : at.back()->cell()));
  }
  std::size_t inside = 0, strangers = 0;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(delaunay_state.mesh.slots()); ++s) {
    if (!delaunay_state.inside(s)) continue;
    ++inside;
    const Tet t = delaunay_state.mesh.corners(s);
    Oracle::Cell_handle cell;
    if (!oracle.is_cell(at[t[0]], at[t[1]], at[t[2]], at[t[3]], cell)) ++strangers;
  }
  EXPECT_GT(inside, delaunay_state.positions().size());
  EXPECT_EQ(strangers, 0U) << "of " << inside;
}

/// What the slots of a Delaunay state say of the output mesh.
void expect_consistent(const Revision& r) {
  const DelaunayState& delaunay_state = *r.delaunay_state;
  const CowVector<Tet>& tets = r.output.mesh.tets;
  ASSERT_EQ(delaunay_state.positions().size(), r.output.mesh.nodes.size());
  ASSERT_EQ(delaunay_state.supports.size(), r.output.mesh.nodes.size());
  std::vector<int> stands(tets.size(), 0);
  std::vector<std::set<std::int32_t>> members(delaunay_state.cavities.size());
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(delaunay_state.mesh.slots()); ++s) {
    if (!delaunay_state.inside(s)) continue;
    if (const std::int32_t c = delaunay_state.cavity_of(s); c >= 0) {
      members[c].insert(s);
      continue;
    }
    const std::int32_t t = delaunay_state.tet_of_slot[s];
    ++stands[t];
    ASSERT_EQ(sorted_nodes(delaunay_state.mesh.corners(s)), sorted_nodes(tets[t]));
  }
  for (std::size_t c = 0; c < members.size(); ++c) {
    const Cavity& cavity = delaunay_state.cavities[c];
    EXPECT_EQ(members[c], std::set<std::int32_t>(cavity.delaunay.begin(), cavity.delaunay.end()));
    for (const std::int32_t t : cavity.output) ++stands[t];
  }
  EXPECT_EQ(std::ranges::count(stands, 1), static_cast<std::ptrdiff_t>(stands.size()))
      << "each delivered tet stands for one slot or is in one cluster";
}

class EditOfCase : public testing::TestWithParam<const char*> {};

TEST_P(EditOfCase, LeavesTheDelaunayMeshOfItsNodes) {
  const std::string name = GetParam();
  const Revision original = first(name.substr(0, name.size() - 1), 4000);
  const Revision remesh = edit(original, test::case_edit(name));
  EXPECT_EQ(remesh.report.strategy, MeshStrategy::Local);
  expect_delaunay(*remesh.delaunay_state);
  expect_consistent(remesh);
}

INSTANTIATE_TEST_SUITE_P(Cases, EditOfCase,
                         testing::Values("simple-ab", "tool1-ab", "tool1-ac", "tool2-ab",
                                         "tool2-bc", "tool2-cd", "tool3-ab"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Part, WhatIsFarFromAnEditStaysAsItIs) {
  const Revision original = first("tool1-a", 15000);
  const Revision remesh = edit(original, ModelEdit{{SetFeatureParameter{"pin1", "radius", 4.5}}});
  const OutputMesh& d = remesh.output;
  const Vec3 pin = remesh.model.features[remesh.model.index_of("pin1")].placement.apply({});
  std::size_t far = 0;
  for (std::size_t t = 0; t < d.mesh.tets.size(); ++t) {
    if (std::ranges::any_of(d.mesh.tets[t],
                            [&](std::int32_t n) { return distance(d.mesh.nodes[n], pin) < 40; }))
      continue;
    ++far;
    ASSERT_GE(d.map.original_tet[t], 0);
    ASSERT_EQ(d.tet_ids[t], original.output.tet_ids[d.map.original_tet[t]]);
  }
  EXPECT_GT(far, 20000U);
  EXPECT_LT(remesh.report.counts.samples, original.report.counts.samples / 2);
}

TEST(Part, CopiesKeepTheirNumberWhereTheMeshGrows) {
  const Revision original = first("tool1-a", 4000);
  const Revision remesh = edit(original, ModelEdit{{SetParameter{"pin_radius", 5.0}}});
  ASSERT_GT(remesh.report.counts.nodes, original.report.counts.nodes);
  const CowVector<std::int32_t>& from = remesh.output.map.original_node;
  for (std::size_t n = 0; n < from.size(); ++n)
    if (from[n] >= 0) {
      ASSERT_EQ(from[n], static_cast<std::int32_t>(n));
    }
}

TEST(Part, TheLastFillTheGapsWhereTheMeshShrinks) {
  const Revision original = first("tool1-a", 4000);
  const Revision remesh = edit(original, ModelEdit{{SetParameter{"pin_radius", 3.0}}});
  const std::uint32_t count = remesh.report.counts.nodes;
  ASSERT_LT(count, original.report.counts.nodes);
  const CowVector<std::int32_t>& from = remesh.output.map.original_node;
  for (std::size_t n = 0; n < from.size(); ++n)
    if (from[n] >= 0 && from[n] != static_cast<std::int32_t>(n)) {
      EXPECT_GE(from[n], static_cast<std::int32_t>(count)) << "moved without need";
    }
  expect_consistent(remesh);
  expect_delaunay(*remesh.delaunay_state);
}

TEST(Part, OfAChainIsCutLikeThatOfAFirstMesh) {
  Revision r = first("tool2-a", 4000);
  for (const char* step : {"tool2-ab", "tool2-bc", "tool2-cd"}) {
    r = edit(r, test::case_edit(step));
    EXPECT_EQ(r.report.strategy, MeshStrategy::Local) << step;
    expect_consistent(r);
  }
  expect_delaunay(*r.delaunay_state);
}

TEST(Part, IsEmptyWhereNothingOfTheMeshChanges) {
  const Revision original = first("tool1-a", 2000);
  AddFeature hidden{test::placed(test::block("hidden", 2, 2, 2), 26, 0, 5), {}};
  const Revision remesh = edit(original, ModelEdit{{hidden}});
  EXPECT_EQ(remesh.report.counts.nodes_kept, original.report.counts.nodes);
  EXPECT_EQ(remesh.report.counts.tets_kept, original.report.counts.tets);
  for (const Warning& w : remesh.report.warnings) {
    EXPECT_NE(w.code, WarningCode::Fallback) << w.message;
    EXPECT_NE(w.code, WarningCode::NodesInserted) << w.message;
  }
}

TEST(Part, MayHaveAllNodesButNotAllTets) {
  for (std::uint32_t nodes = 300; nodes < 3000; nodes += 300) {
    const Revision original = first("tool1-a", nodes);
    const Revision remesh = edit(original, ModelEdit{{SetFeatureParameter{"pin1", "radius", 5.0}}});
    EXPECT_EQ(remesh.report.strategy, MeshStrategy::Local) << nodes;
    expect_consistent(remesh);
  }
}

TEST(CutOut, HasAllTetsOfItsInnerNodesAndWholeClusters) {
  const Revision original = first("tool1-a", 4000);
  const DelaunayState& delaunay_state = *original.delaunay_state;
  std::vector<std::uint8_t> inner(delaunay_state.positions().size(), 0);
  for (std::size_t n = 0; n < inner.size(); ++n)
    inner[n] = norm(delaunay_state.positions()[n] - Vec3{30, 0, 6}) < 12 ? 1 : 0;
  const MeshPatch patch = cut_patch(copied_mesh(original), inner, nullptr);
  std::vector<int> tets_at(inner.size(), 0), in_part(inner.size(), 0);
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(delaunay_state.mesh.slots()); ++s)
    if (delaunay_state.inside(s))
      for (const std::int32_t n : delaunay_state.mesh.corners(s)) ++tets_at[n];
  for (const Tet& t : patch.tets)
    for (const std::int32_t p : t) ++in_part[patch.nodes[p]];
  for (std::size_t p = 0; p < patch.nodes.size(); ++p) {
    const std::int32_t n = patch.nodes[p];
    EXPECT_EQ(patch.inner[p], inner[n]);
    EXPECT_EQ(patch.positions[p], delaunay_state.positions()[n]);
    if (inner[n]) {
      EXPECT_EQ(in_part[n], tets_at[n]);
    }
  }
  double peeled = 0, output = 0;
  const auto volume = [](const Tet& t, const std::vector<Vec3>& p) {
    return dot(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), p[t[3]] - p[t[0]]) / 6;
  };
  for (const Tet& t : patch.tets) peeled += volume(t, patch.positions);
  for (const Tet& t : patch.output) output += volume(t, patch.positions);
  EXPECT_NEAR(peeled, output, 1e-3 * peeled) << "the same hull";
}

}  // namespace
}  // namespace remeshd
