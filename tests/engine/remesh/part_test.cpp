#include "engine/remesh/part.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/remesh/remesh.h"
#include "engine/remesh/tet_index.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

Revision first(const std::string& name, std::uint32_t nodes) {
  return make_revision(nullptr, test::case_model(name), {.nodes = nodes, .iterations = 5}, kRun);
}

Revision edit(const Revision& original, const ModelEdit& change) {
  return make_revision(&original, apply(original.source, change), {.iterations = 5}, kRun);
}

/// Every tet of a master is a cell of the triangulation that CGAL makes of its nodes.
void expect_delaunay(const Master& master) {
  using K = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Oracle = CGAL::Delaunay_triangulation_3<K>;
  Oracle oracle;
  std::vector<Oracle::Vertex_handle> at;
  for (const Vec3& p : master.positions()) {
    at.push_back(oracle.insert(K::Point_3(p.x, p.y, p.z),
                               at.empty() ? Oracle::Cell_handle() : at.back()->cell()));
  }
  std::size_t inside = 0, strangers = 0;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(master.mesh.slots()); ++s) {
    if (!master.inside(s)) continue;
    ++inside;
    const Tet t = master.mesh.corners(s);
    Oracle::Cell_handle cell;
    if (!oracle.is_cell(at[t[0]], at[t[1]], at[t[2]], at[t[3]], cell)) ++strangers;
  }
  EXPECT_GT(inside, master.positions().size());
  EXPECT_EQ(strangers, 0U) << "of " << inside;
}

/// What the slots of a master say of the delivered mesh.
void expect_consistent(const Revision& r) {
  const Master& master = *r.master;
  const Pages<Tet>& tets = r.delivery.mesh.tets;
  ASSERT_EQ(master.positions().size(), r.delivery.mesh.nodes.size());
  ASSERT_EQ(master.supports.size(), r.delivery.mesh.nodes.size());
  std::vector<int> stands(tets.size(), 0);
  std::vector<std::set<std::int32_t>> members(master.clusters.size());
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(master.mesh.slots()); ++s) {
    if (!master.inside(s)) continue;
    if (const std::int32_t c = master.cluster_of(s); c >= 0) {
      members[c].insert(s);
      continue;
    }
    const std::int32_t t = master.tet_of_slot[s];
    ++stands[t];
    ASSERT_EQ(sorted_nodes(master.mesh.corners(s)), sorted_nodes(tets[t]));
  }
  for (std::size_t c = 0; c < members.size(); ++c) {
    const Cluster& cluster = master.clusters[c];
    EXPECT_EQ(members[c], std::set<std::int32_t>(cluster.delaunay.begin(), cluster.delaunay.end()));
    for (const std::int32_t t : cluster.delivered) ++stands[t];
  }
  EXPECT_EQ(std::ranges::count(stands, 1), static_cast<std::ptrdiff_t>(stands.size()))
      << "each delivered tet stands for one slot or is in one cluster";
}

class EditOfCase : public testing::TestWithParam<const char*> {};

TEST_P(EditOfCase, LeavesTheDelaunayMeshOfItsNodes) {
  const std::string name = GetParam();
  const Revision original = first(name.substr(0, name.size() - 1), 4000);
  const Revision remesh = edit(original, test::case_edit(name));
  EXPECT_EQ(remesh.report.way, Way::Local);
  expect_delaunay(*remesh.master);
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
  const Delivery& d = remesh.delivery;
  const Vec3 pin = remesh.model.features[remesh.model.index_of("pin1")].placement.apply({});
  std::size_t far = 0;
  for (std::size_t t = 0; t < d.mesh.tets.size(); ++t) {
    if (std::ranges::any_of(d.mesh.tets[t],
                            [&](std::int32_t n) { return distance(d.mesh.nodes[n], pin) < 40; }))
      continue;
    ++far;
    ASSERT_GE(d.map.original_tet[t], 0);
    ASSERT_EQ(d.tet_ids[t], original.delivery.tet_ids[d.map.original_tet[t]]);
  }
  EXPECT_GT(far, 20000U);
  EXPECT_LT(remesh.report.counts.samples, original.report.counts.samples / 2);
}

TEST(Part, CopiesKeepTheirNumberWhereTheMeshGrows) {
  const Revision original = first("tool1-a", 4000);
  const Revision remesh = edit(original, ModelEdit{{SetParameter{"pin_radius", 5.0}}});
  ASSERT_GT(remesh.report.counts.nodes, original.report.counts.nodes);
  const Pages<std::int32_t>& from = remesh.delivery.map.original_node;
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
  const Pages<std::int32_t>& from = remesh.delivery.map.original_node;
  for (std::size_t n = 0; n < from.size(); ++n)
    if (from[n] >= 0 && from[n] != static_cast<std::int32_t>(n)) {
      EXPECT_GE(from[n], static_cast<std::int32_t>(count)) << "moved without need";
    }
  expect_consistent(remesh);
  expect_delaunay(*remesh.master);
}

TEST(Part, OfAChainIsCutLikeThatOfAFirstMesh) {
  Revision r = first("tool2-a", 4000);
  for (const char* step : {"tool2-ab", "tool2-bc", "tool2-cd"}) {
    r = edit(r, test::case_edit(step));
    EXPECT_EQ(r.report.way, Way::Local) << step;
    expect_consistent(r);
  }
  expect_delaunay(*r.master);
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
    EXPECT_EQ(remesh.report.way, Way::Local) << nodes;
    expect_consistent(remesh);
  }
}

TEST(CutOut, HasAllTetsOfItsInnerNodesAndWholeClusters) {
  const Revision original = first("tool1-a", 4000);
  const Master& master = *original.master;
  std::vector<std::uint8_t> inner(master.positions().size(), 0);
  for (std::size_t n = 0; n < inner.size(); ++n)
    inner[n] = norm(master.positions()[n] - Vec3{30, 0, 6}) < 12 ? 1 : 0;
  const OriginalPart part =
      cut_out(master, {original.master_nodes(), original.delivery.mesh.tets}, inner, nullptr);
  std::vector<int> tets_at(inner.size(), 0), in_part(inner.size(), 0);
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(master.mesh.slots()); ++s)
    if (master.inside(s))
      for (const std::int32_t n : master.mesh.corners(s)) ++tets_at[n];
  for (const Tet& t : part.tets)
    for (const std::int32_t p : t) ++in_part[part.nodes[p]];
  for (std::size_t p = 0; p < part.nodes.size(); ++p) {
    const std::int32_t n = part.nodes[p];
    EXPECT_EQ(part.inner[p], inner[n]);
    EXPECT_EQ(part.positions[p], master.positions()[n]);
    if (inner[n]) {
      EXPECT_EQ(in_part[n], tets_at[n]);
    }
  }
  double peeled = 0, delivered = 0;
  const auto volume = [](const Tet& t, const std::vector<Vec3>& p) {
    return dot(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), p[t[3]] - p[t[0]]) / 6;
  };
  for (const Tet& t : part.tets) peeled += volume(t, part.positions);
  for (const Tet& t : part.delivered) delivered += volume(t, part.positions);
  EXPECT_NEAR(peeled, delivered, 1e-3 * peeled) << "the same hull";
}

}  // namespace
}  // namespace remeshd
