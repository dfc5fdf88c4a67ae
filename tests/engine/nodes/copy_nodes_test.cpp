#include "engine/nodes/copy_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/nodes/active_faces.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

struct Copied {
  Revision original;
  FeatureModel modified;
  CopyPlan source;
  CopiedNodes nodes;

  Copied(const std::string& name, const ModelEdit& edit)
      : original(make_revision(Revision::none(), test::case_model(name),
                               {.nodes = 2500, .iterations = 4}, kRun)),
        modified(evaluate(apply(original.source, edit))),
        source(original.model, modified, {original.edge_length}, kRun),
        nodes(copy_all()) {}

  CopiedNodes copy_all() const {
    const DelaunayState& delaunay_state = *original.delaunay_state;
    std::vector<Tet> tets;
    for (std::int32_t s = 0; s < static_cast<std::int32_t>(delaunay_state.mesh.slots()); ++s)
      if (delaunay_state.inside(s)) tets.push_back(delaunay_state.mesh.corners(s));
    std::vector<std::int32_t> all(delaunay_state.positions().size());
    std::iota(all.begin(), all.end(), 0);
    return copy_nodes(source, {delaunay_state.positions(), delaunay_state.supports, all, tets},
                      original.edge_length, kRun);
  }
};

TEST(CopyNodes, EachNodeIsCopiedAtMostOnce) {
  const Copied c("fig6-a", test::case_edit("fig6-ab"));
  std::vector<std::int32_t> originals = c.nodes.original;
  ASSERT_GT(originals.size(), 1500U);
  std::sort(originals.begin(), originals.end());
  EXPECT_GE(originals.front(), 0);
  EXPECT_EQ(std::adjacent_find(originals.begin(), originals.end()), originals.end());
}

TEST(CopyNodes, AFixedCopyIsTheTransformedOriginalToTheBit) {
  const Copied c("simple-a", test::case_edit("simple-ab"));
  int stayed = 0, moved = 0;
  for (std::int32_t n = 0; n < c.nodes.size(); ++n) {
    if (c.nodes.is_free(n)) continue;
    const Vec3& original = c.original.delaunay_state->positions()[c.nodes.original[n]];
    EXPECT_EQ(c.nodes.positions[n], c.source.transforms()[c.nodes.transform[n]].apply(original));
    (c.nodes.positions[n] == original ? stayed : moved)++;
  }
  EXPECT_GT(stayed, 1500);
  EXPECT_GT(moved, 70);  // with the top
}

TEST(CopyNodes, NoneLandsWhereTheNewHolesAre) {
  const Copied c("tool1-a", test::case_edit("tool1-ac"));
  for (const char* hole : {"hole1", "hole2", "hole3", "hole4"}) {
    const auto& placement = c.modified.features[c.modified.index_of(hole)].placement.m;
    int deep_inside = 0, beside = 0;
    for (const Vec3& p : c.nodes.positions) {
      if (p.z <= 0 || p.z >= 12) continue;
      const double from_axis = std::hypot(p.x - placement[3], p.y - placement[7]);
      deep_inside += from_axis < 4.9;
      beside += from_axis > 5 && from_axis < 10;
    }
    EXPECT_EQ(deep_inside, 0) << hole;
    EXPECT_GT(beside, 20) << hole;
  }
}

TEST(CopyNodes, TheMovedTopTakesItsNodesAlong) {
  const Copied c("simple-a", test::case_edit("simple-ab"));
  int on_top = 0;
  for (const Vec3& p : c.nodes.positions) on_top += p.z > 41 && p.x > 5 && p.x < 35;
  EXPECT_GT(on_top, 70);  // 18000 of 258000 mm^3 hold about 170, its foot included
  for (const Vec3& p : c.nodes.positions) EXPECT_FALSE(p.z > 41 && p.x < 0);
}

TEST(CopyNodes, NodesOnTheWallOfAHoleThatGrewALittleAreSetBackInProportion) {
  // The wall moves by a fifth of the edge length: about a quarter of its nodes have lost their
  // room.
  const Copied base("fig11-a", ModelEdit{{SetParameter{"rib_dx", 10.0}}});
  const double l = base.original.edge_length;
  const Copied c("fig11-a", ModelEdit{{SetParameter{"hole_radius", 8.0 + 0.2 * l}}});
  int on_wall = 0, set_back = 0;
  for (std::size_t n = 0; n < c.original.delaunay_state->positions().size(); ++n) {
    const Vec3& p = c.original.delaunay_state->positions()[n];
    on_wall += std::fabs(std::hypot(p.x + 20, p.y) - 8) < 1e-6;
  }
  for (std::int32_t n = 0; n < c.nodes.size(); ++n) {
    set_back += c.nodes.is_free(n) ? 1 : 0;
    EXPECT_TRUE(c.source.modified().inside(c.nodes.positions[n]) || !c.nodes.is_free(n));
  }
  EXPECT_GT(on_wall, 50);
  EXPECT_NEAR(set_back, (1 - 0.2 * 1.22) * on_wall, 0.15 * on_wall);
}

TEST(ActiveFaces, FreeTheNodesAtOldAndNewFootAndNoOthers) {
  Copied c("fig6-a", test::case_edit("fig6-ab"));
  const double l = c.original.edge_length;
  free_at_active_faces(c.nodes, c.source, l, kRun);
  int freed = 0;
  for (std::int32_t n = 0; n < c.nodes.size(); ++n) {
    if (!c.nodes.is_free(n)) continue;
    ++freed;
    const Vec3& p = c.nodes.positions[n];
    const bool at_a_foot = std::fabs(p.z - 10) < 1.2 * l && std::fabs(p.y) < 15 + 1.2 * l &&
                           (std::fabs(p.x + 20) < 5 + 1.2 * l || std::fabs(p.x - 10) < 5 + 1.2 * l);
    EXPECT_TRUE(at_a_foot) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(freed, 50);
  EXPECT_LT(freed, 0.3 * c.nodes.size());
}

}  // namespace
}  // namespace remeshd
