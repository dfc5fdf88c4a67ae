#include "engine/second_order/mid_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "engine/boundary/facet_faces.h"
#include "engine/remesh/remesh.h"
#include "engine/second_order/jacobian.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

MeshOptions second_order(std::uint32_t nodes) {
  return {.nodes = nodes, .order = 2, .sizing = {.even = false}};
}

ModelSource plate() {
  return test::model_of(
      {test::block("plate", 60, 40, 12),
       test::placed(test::cylinder("hole", 6, 14), -12, 0, -1, Nature::Subtractive),
       test::placed(test::cylinder("pin", 4, 16), 15, 5, 0)});
}

const Revision& base() {
  static const Revision made = make_revision(Revision::none(), plate(), second_order(1500), kRun);
  return made;
}

Revision edited(const Revision& parent, const Edit& edit, std::uint32_t order = 2) {
  MeshOptions options = parent.options;
  options.nodes.reset();
  options.order = order;
  return make_revision(parent, apply(parent.source, {{edit}}), options, kRun);
}

QuadraticTet tet_of(const Revision& r, std::size_t t) {
  QuadraticTet tet;
  for (int k = 0; k < 4; ++k) tet.corners[k] = r.output.mesh.nodes[r.output.mesh.tets[t][k]];
  for (int k = 0; k < 6; ++k) tet.mids[k] = r.output.mids.positions[r.output.mids.of_tets[t][k]];
  return tet;
}

/// Every edge of every tet has the mid-node between its corners, and no other is there.
void expect_one_for_each_edge(const Revision& r) {
  const MidNodes& mids = r.output.mids;
  std::map<std::array<std::int32_t, 2>, std::int32_t> of_edge;
  r.output.mesh.tets.for_each([&](std::size_t t, const Tet& tet) {
    for (int k = 0; k < 6; ++k) {
      std::array<std::int32_t, 2> edge{tet[kTetEdges[k][0]], tet[kTetEdges[k][1]]};
      if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
      const std::int32_t mid = mids.of_tets[t][k];
      ASSERT_EQ(mids.edges[mid], edge);
      ASSERT_EQ(of_edge.emplace(edge, mid).first->second, mid);
    }
  });
  EXPECT_EQ(of_edge.size(), mids.positions.size());
  EXPECT_EQ(r.report.counts.mid_nodes, mids.positions.size());
}

/// Mid-nodes of facets lie on the faces that both facets beside them are of; on model edges too.
void expect_on_the_boundary(const Revision& r) {
  const std::vector<Support> supports = r.supports().flat();
  const BoundaryModel& boundary = r.cells.boundary;
  const FacetFaces faces(boundary, supports);
  const MidNodes& mids = r.output.mids;
  const std::set<std::int32_t> straight(mids.straightened.begin(), mids.straightened.end());
  int curved = 0;
  for (const MeshFacet& facet : r.output.groups.facets) {
    const auto& p = r.output.mesh.nodes;
    const int face =
        faces.face_of(facet.nodes, p[facet.nodes[0]], p[facet.nodes[1]], p[facet.nodes[2]]);
    const Tet& tet = r.output.mesh.tets[facet.tet];
    for (int k = 0; k < 6; ++k) {
      if (!has_corner(facet.nodes, tet[kTetEdges[k][0]]) ||
          !has_corner(facet.nodes, tet[kTetEdges[k][1]]))
        continue;
      const std::int32_t mid = mids.of_tets[facet.tet][k];
      if (straight.contains(mid)) continue;
      EXPECT_LT(faces.deviation(face, mids.positions[mid]), 1e-9);
      curved += boundary.faces[face].surface.kind == Surface::Kind::Cylinder ? 1 : 0;
    }
  }
  EXPECT_GT(curved, 100);
}

void expect_valid(const Revision& r) {
  for (std::size_t t = 0; t < r.output.mesh.tets.size(); ++t)
    EXPECT_GT(least_jacobian(tet_of(r, t)), 0) << t;
}

void expect_second_order(const Revision& r) {
  expect_one_for_each_edge(r);
  expect_on_the_boundary(r);
  expect_valid(r);
}

/// Kept ones are their originals, transformed, to the bit; ids are never given twice.
void expect_maps(const Revision& parent, const Revision& r) {
  const MidNodes &was = parent.output.mids, &now = r.output.mids;
  std::set<std::uint64_t> ids;
  for (std::size_t mid = 0; mid < now.positions.size(); ++mid) {
    EXPECT_TRUE(ids.insert(now.ids[mid]).second);
    EXPECT_LT(now.ids[mid], now.next_id);
    const std::int32_t o = now.original[mid];
    if (o < 0) {
      EXPECT_EQ(now.origin[mid], NodeOrigin::New);
      EXPECT_GE(now.ids[mid], was.next_id);
      continue;
    }
    EXPECT_EQ(now.ids[mid], was.ids[o]);
    if (now.origin[mid] != NodeOrigin::Kept) continue;
    EXPECT_EQ(now.positions[mid],
              r.output.map.transforms[now.transform[mid]].apply(was.positions[o]));
  }
}

std::size_t kept_of(const Revision& r) {
  std::size_t kept = 0;
  r.output.mids.origin.for_each(
      [&](std::size_t, NodeOrigin origin) { kept += origin == NodeOrigin::Kept ? 1 : 0; });
  return kept;
}

TEST(MidNodes, OfAFirstMeshLieOnTheModelsFaces) {
  expect_second_order(base());
  EXPECT_EQ(base().report.counts.straight_edges, 0U);
  expect_maps(Revision::none(), base());
}

TEST(MidNodes, FollowCirclesMoreCloselyThanChords) {
  // Volume of the quadratic tets, by a rule that is exact for the cubic Jacobian determinant.
  double chords = 0, curved = 0;
  for (std::size_t t = 0; t < base().output.mesh.tets.size(); ++t) {
    const QuadraticTet tet = tet_of(base(), t);
    const auto& c = tet.corners;
    chords += dot(cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0]) / 6;
    constexpr double kOuter = 1.0 / 6;
    const auto jacobian = [&](const std::array<double, 4>& at) {
      std::array<Vec3, 3> columns;
      for (int k = 0; k < 3; ++k) {
        const auto slope = [&](int by) {
          Vec3 d = (4 * at[by] - 1) * c[by];
          for (int e = 0; e < 6; ++e) {
            if (kTetEdges[e][0] == by) d += 4 * at[kTetEdges[e][1]] * tet.mids[e];
            if (kTetEdges[e][1] == by) d += 4 * at[kTetEdges[e][0]] * tet.mids[e];
          }
          return d;
        };
        columns[k] = slope(k + 1) - slope(0);
      }
      return dot(cross(columns[0], columns[1]), columns[2]);
    };
    double sum = -0.8 * jacobian({0.25, 0.25, 0.25, 0.25});
    for (int k = 0; k < 4; ++k) {
      std::array<double, 4> at{kOuter, kOuter, kOuter, kOuter};
      at[k] = 0.5;
      sum += 0.45 * jacobian(at);
    }
    curved += sum / 6;
  }
  const double exact = base().cells.volume;
  EXPECT_LT(std::fabs(curved - exact), 0.05 * std::fabs(chords - exact));
}

TEST(MidNodes, AnEditKeepsThoseOfWhatItKeeps) {
  const Revision r = edited(base(), SetFeatureParameter{"hole", "radius", 6.8});
  ASSERT_EQ(r.report.strategy, MeshStrategy::Local);
  expect_second_order(r);
  expect_maps(base(), r);
  EXPECT_GT(kept_of(r), base().output.mids.positions.size() / 2);
  // What stays keeps its number too, so that little of the arrays differs.
  std::size_t in_place = 0;
  r.output.mids.original.for_each([&](std::size_t mid, std::int32_t o) {
    in_place += o == static_cast<std::int32_t>(mid) ? 1 : 0;
  });
  EXPECT_GT(in_place, kept_of(r) * 9 / 10);
}

TEST(MidNodes, MoveWithTheFeatureThatTheyAreCopiedWith) {
  const Revision r =
      edited(base(), SetPlacement{"pin", PlacementSource{{17.5, -6.0, 0.0}, {}, {}}});
  expect_second_order(r);
  expect_maps(base(), r);
}

TEST(MidNodes, FollowAMorphedMesh) {
  const Revision r = edited(base(), SetFeatureParameter{"hole", "radius", 6.0001});
  ASSERT_EQ(r.report.strategy, MeshStrategy::Morphed);
  expect_second_order(r);
  expect_maps(base(), r);
  EXPECT_EQ(r.output.mids.ids, base().output.mids.ids);
}

TEST(MidNodes, OfTheSameMeshAreTheSame) {
  const Revision r = edited(base(), SetFeatureParameter{"hole", "radius", 6.0});
  ASSERT_EQ(r.report.strategy, MeshStrategy::Unchanged);
  EXPECT_EQ(r.output.mids.positions, base().output.mids.positions);
  EXPECT_EQ(r.output.mids.of_tets, base().output.mids.of_tets);
  EXPECT_EQ(kept_of(r), r.output.mids.positions.size());
}

TEST(MidNodes, ComeAndGoWithTheOrder) {
  const Revision linear = edited(base(), SetFeatureParameter{"hole", "radius", 6.8}, 1);
  EXPECT_TRUE(linear.output.mids.positions.empty());
  EXPECT_EQ(linear.report.counts.mid_nodes, 0U);
  const Revision again = edited(linear, SetFeatureParameter{"hole", "radius", 6.0});
  expect_second_order(again);
  for (const std::uint64_t id : again.output.mids.ids)
    EXPECT_GE(id, base().output.mids.next_id);  // no id is given twice along a chain
}

TEST(MidNodes, TheCornersAreThoseOfTheFirstOrder) {
  MeshOptions linear = second_order(1500);
  linear.order = 1;
  const Revision r = make_revision(Revision::none(), plate(), linear, kRun);
  EXPECT_EQ(r.output.mesh.nodes, base().output.mesh.nodes);
  EXPECT_EQ(r.output.mesh.tets, base().output.mesh.tets);
}

TEST(MidNodes, AreStoredWithTheRevision) {
  const Revision once = edited(base(), SetFeatureParameter{"hole", "radius", 6.8});
  const Revision loaded = test::stored_and_loaded(once);
  EXPECT_EQ(loaded.options.order, 2U);
  EXPECT_EQ(loaded.output.mids.positions, once.output.mids.positions);
  EXPECT_EQ(loaded.output.mids.edges, once.output.mids.edges);
  EXPECT_EQ(loaded.report.counts.mid_nodes, once.report.counts.mid_nodes);
  const Edit next = SetFeatureParameter{"hole", "radius", 7.2};
  EXPECT_EQ(edited(loaded, next).output.mids.positions, edited(once, next).output.mids.positions);
  EXPECT_EQ(edited(loaded, next).output.mids.ids, edited(once, next).output.mids.ids);
}

/// A film of a wall between a drill and a plate's side: curved edges would turn tets over.
Revision film_beside_a_drill(double hold) {
  const ModelSource thin = test::model_of(
      {test::block("plate", 40, 40, 10),
       test::placed(test::cylinder("drill", 8, 12), 11.95, 0, -1, Nature::Subtractive)});
  MeshOptions options = second_order(400);
  options.sizing = {.even = true};
  options.hold = hold;
  return make_revision(Revision::none(), thin, options, kRun);
}

TEST(MidNodes, StayInTheMiddleOfStraightEdgesRatherThanTurnATetOver) {
  const Revision r = film_beside_a_drill(0);
  expect_one_for_each_edge(r);
  expect_valid(r);
  EXPECT_GT(r.report.counts.straight_edges, 0U);
  EXPECT_EQ(r.report.warnings.back().code, WarningCode::EdgesStraight);
  for (const std::int32_t mid : r.output.mids.straightened) {
    const auto& [a, b] = r.output.mids.edges[mid];
    EXPECT_EQ(r.output.mids.positions[mid],
              0.5 * (r.output.mesh.nodes[a] + r.output.mesh.nodes[b]));
  }
}

TEST(MidNodes, ThatWereStraightenedStaySoWhileTheConnectivityIsHeld) {
  const Revision r = film_beside_a_drill(2);
  ASSERT_FALSE(r.output.mids.straightened.empty());
  const Revision held = edited(r, SetFeatureParameter{"drill", "radius", 7.9});
  ASSERT_EQ(held.report.strategy, MeshStrategy::Morphed);
  expect_valid(held);
  EXPECT_TRUE(std::ranges::includes(held.output.mids.straightened, r.output.mids.straightened));
}

struct TetOnTheHole {
  std::size_t tet;
  std::int32_t apex, curved;  ///< its node inside of the model; a mid-node opposite
};

/// A tet with three nodes on the hole's wall and one inside of the model.
TetOnTheHole tet_on_the_hole(const Revision& r) {
  const std::vector<Support> supports = r.supports().flat();
  const MidNodes& mids = r.output.mids;
  for (const MeshFacet& facet : r.output.groups.facets) {
    if (r.output.groups.facet_groups[facet.group] != std::vector<std::string>{"hole.wall"})
      continue;
    const auto t = static_cast<std::size_t>(facet.tet);
    const Tet& tet = r.output.mesh.tets[t];
    const auto apex =
        *std::ranges::find_if(tet, [&](std::int32_t n) { return !has_corner(facet.nodes, n); });
    if (supports[apex].kind != Support::Kind::Interior) continue;
    for (int k = 0; k < 6; ++k) {
      const std::int32_t mid = mids.of_tets[t][k];
      const auto& [a, b] = mids.edges[mid];
      const Vec3 middle = 0.5 * (r.output.mesh.nodes[a] + r.output.mesh.nodes[b]);
      if (a != apex && b != apex && distance(mids.positions[mid], middle) > 0.05)
        return {t, apex, mid};
    }
  }
  throw std::logic_error("no tet on the hole");
}

/// Puts a node somewhere else, its edges straight.
void put(Revision& r, std::int32_t node, const Vec3& place) {
  r.output.mesh.nodes.edit(node) = place;
  for (std::size_t mid = 0; mid < r.output.mids.edges.size(); ++mid) {
    const auto& [a, b] = r.output.mids.edges[mid];
    if (a != node && b != node) continue;
    r.output.mids.positions.edit(mid) = 0.5 * (r.output.mesh.nodes[a] + r.output.mesh.nodes[b]);
  }
}

// As a flip makes them: its edges were those of other tets, in which they could be curved.
TEST(MidNodes, ANewTetThatHasOnlyEdgesOfOldOnesIsNotTurnedOver) {
  Revision parent = base();
  const auto [tet, apex, curved] = tet_on_the_hole(parent);
  const Vec3 between = parent.output.mids.positions[curved];  // where the curve comes to lie
  Revision r = edited(base(), SetFeatureParameter{"hole", "radius", 6.0});
  for (Revision* both : {&parent, &r}) put(*both, apex, between);
  ASSERT_LT(least_jacobian(tet_of(r, tet)), 0.1);
  r.output.map.original_tet.edit(tet) = -1;
  add_mid_nodes(parent, r, kRun);
  EXPECT_GE(least_jacobian(tet_of(r, tet)), 0.1);
}

}  // namespace
}  // namespace remeshd
