#include "engine/improve/improve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/boundary/edge_chains.h"
#include "engine/mesh/quality.h"
#include "tests/support/solid_fixture.h"
#include "tests/support/tet_neighbours.h"

namespace remeshd {
namespace {

using test::make_box;
using test::make_cylinder;
using test::SolidFixture;

const Transform kTilted =
    Transform::frame({2.0 / 3, 2.0 / 3, 1.0 / 3}, {-2.0 / 3, 1.0 / 3, 2.0 / 3},
                     {1.0 / 3, -2.0 / 3, 2.0 / 3}, {5, -3, 2});

ImproveResult clean(const SolidFixture& s, const ImproveOptions& options = {}) {
  return improve(s.mesh, s.supports, s.boundary, s.all_dirty(), options, remeshd::Run{});
}

bool has_edge(const TetMesh& mesh, std::int32_t a, std::int32_t b) {
  return std::any_of(mesh.tets.begin(), mesh.tets.end(), [&](const Tet& t) {
    return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
  });
}

/// Boundary facets and whether every edge of theirs is in exactly two of them.
struct Shell {
  std::size_t facets = 0;
  bool closed = true;
};
Shell shell(const TetMesh& mesh) {
  const auto neighbours = test::tet_neighbours(mesh.tets, mesh.nodes.size());
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  Shell result;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (int i = 0; i < 4; ++i) {
      if (neighbours[t][i] >= 0) continue;
      ++result.facets;
      for (int k = 0; k < 3; ++k)
        edges.emplace_back(mesh.tets[t][kTetFacets[i][k]],
                           mesh.tets[t][kTetFacets[i][(k + 1) % 3]]);
    }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) result.closed = false;
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair{b, a})) result.closed = false;
  return result;
}

class ImproveSeeds : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, ImproveSeeds, testing::Range<std::uint64_t>(1, 11));

TEST_P(ImproveSeeds, RaisesABoxOfSliversToTheThresholdAndTwentyDegrees) {
  const SolidFixture s = make_box({2, 1, 1}, 14, GetParam());
  const Quality before = measure_quality(s.mesh.nodes, s.mesh.tets, {});
  ASSERT_LT(before.dihedral_min, 3);
  const ImproveResult result = clean(s);
  const Quality after = measure_quality(result.mesh.nodes, result.mesh.tets, {});
  EXPECT_EQ(result.below_threshold, 0U);
  EXPECT_GE(after.volume_length_min, 0.45);
  EXPECT_GE(after.dihedral_min, 20);
  EXPECT_LE(after.dihedral_max, 150);
  EXPECT_GT(after.volume_length_mean, before.volume_length_mean);
}

TEST_P(ImproveSeeds, KeepsTheVolumeAndEveryFaceOfATiltedBoxToRounding) {
  // In a tilted frame coplanar nodes make flat tets on the faces, which must be peeled or flipped.
  const SolidFixture s = make_box({1, 1, 1}, 10, GetParam(), 0.3, kTilted);
  const ImproveResult result = clean(s);
  EXPECT_NEAR(measure_quality(result.mesh.nodes, result.mesh.tets, {}).volume, 1.0, 1e-12);
  EXPECT_TRUE(shell(result.mesh).closed);
  for (std::size_t n = 0; n < s.supports.size(); ++n)
    EXPECT_LT(
        distance(project(s.boundary, s.supports[n], result.mesh.nodes[n]), result.mesh.nodes[n]),
        1e-13)
        << "node " << n << " left its support";
}

TEST_P(ImproveSeeds, LeavesACylinderClosedWithItsCirclesAndNearlyItsVolume) {
  const SolidFixture s = make_cylinder(5, 4, 40, GetParam());
  const Quality before = measure_quality(s.mesh.nodes, s.mesh.tets, {});
  const ImproveResult result = clean(s);
  const Quality after = measure_quality(result.mesh.nodes, result.mesh.tets, {});
  EXPECT_GE(after.volume_length_min, 0.44);
  EXPECT_GE(after.dihedral_min, 20);
  EXPECT_NEAR(after.volume, before.volume, 0.003 * before.volume);
  EXPECT_TRUE(shell(result.mesh).closed);
  for (const auto& chain : edge_chains(s.boundary, s.supports, result.mesh.nodes))
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      EXPECT_TRUE(has_edge(result.mesh, chain[i].node, chain[i + 1].node));
}

TEST(Improve, KeepsModelVerticesInPlaceAndModelEdgesChainsOfMeshEdges) {
  const SolidFixture s = make_box({1, 1, 1}, 8, 3, 0.3);
  const ImproveResult result = clean(s);
  for (std::size_t n = 0; n < s.supports.size(); ++n) {
    if (s.supports[n].kind != Support::Kind::Vertex) continue;
    EXPECT_EQ(result.mesh.nodes[n], s.mesh.nodes[n]);
    EXPECT_EQ(result.node_moved[n], 0);
  }
  for (const auto& chain : edge_chains(s.boundary, s.supports, result.mesh.nodes)) {
    EXPECT_EQ(chain.size(), 9U);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      EXPECT_TRUE(has_edge(result.mesh, chain[i].node, chain[i + 1].node));
  }
}

TEST(Improve, TellsExactlyWhichNodesMoved) {
  const SolidFixture s = make_box({2, 1, 1}, 14, 1);
  const ImproveResult result = clean(s);
  ASSERT_EQ(result.node_moved.size(), s.mesh.nodes.size());
  std::size_t moved = 0;
  for (std::size_t n = 0; n < s.mesh.nodes.size(); ++n) {
    EXPECT_EQ(result.node_moved[n] != 0, result.mesh.nodes[n] != s.mesh.nodes[n]) << "node " << n;
    moved += result.node_moved[n];
  }
  EXPECT_GT(moved, 0U);
  EXPECT_LT(moved, s.mesh.nodes.size() / 5);
}

TEST(Improve, TellsWhichTetsAreStillThoseOfTheInput) {
  const SolidFixture s = make_cylinder(5, 4, 30, 7);
  const ImproveResult result = clean(s);
  ASSERT_EQ(result.was.size(), result.mesh.tets.size());
  std::size_t still = 0;
  for (std::size_t t = 0; t < result.was.size(); ++t) {
    if (result.was[t] < 0) continue;
    EXPECT_EQ(result.mesh.tets[t], s.mesh.tets[result.was[t]]);
    ++still;
  }
  EXPECT_GT(still, s.mesh.tets.size() / 2);
  EXPECT_LT(still, s.mesh.tets.size());
}

TEST(Improve, WithNothingDirtyChangesNothing) {
  const SolidFixture s = make_box({1, 1, 1}, 8, 2);
  const std::vector<std::uint8_t> none(s.mesh.tets.size(), 0);
  const ImproveResult result = improve(s.mesh, s.supports, s.boundary, none, {}, remeshd::Run{});
  EXPECT_EQ(result.mesh.tets, s.mesh.tets);
  EXPECT_EQ(result.mesh.nodes, s.mesh.nodes);
  EXPECT_EQ(result.below_threshold, 0U);
}

TEST(Improve, LeavesTheMeshFarFromDirtyTetsAsItIs) {
  const SolidFixture s = make_box({4, 1, 1}, 24, 2);
  std::vector<std::uint8_t> dirty(s.mesh.tets.size(), 0);
  const auto x = [&](const Tet& t) {
    return 0.25 * (s.mesh.nodes[t[0]].x + s.mesh.nodes[t[1]].x + s.mesh.nodes[t[2]].x +
                   s.mesh.nodes[t[3]].x);
  };
  for (std::size_t t = 0; t < dirty.size(); ++t) dirty[t] = x(s.mesh.tets[t]) < 1 ? 1 : 0;
  const ImproveResult result = improve(s.mesh, s.supports, s.boundary, dirty, {}, remeshd::Run{});
  const auto far = [&](const std::vector<Tet>& tets) {
    std::vector<Tet> found;
    std::copy_if(tets.begin(), tets.end(), std::back_inserter(found),
                 [&](const Tet& t) { return x(t) > 2; });
    return found;
  };
  EXPECT_EQ(far(result.mesh.tets), far(s.mesh.tets)) << "the same tets in the same order";
  for (std::size_t n = 0; n < s.mesh.nodes.size(); ++n)
    if (s.mesh.nodes[n].x > 2) {
      EXPECT_EQ(result.node_moved[n], 0);
    }
  EXPECT_NE(result.mesh.tets, s.mesh.tets);
}

TEST(Improve, ConfinedDoesNotWanderThroughTetsThatWereBadAllAlong) {
  // By these goals most tets are bad: each that a repair touches would be the next.
  const SolidFixture s = make_box({4, 1, 1}, 14, 3);
  std::vector<std::uint8_t> dirty(s.mesh.tets.size(), 0);
  std::vector<std::uint8_t> near(s.mesh.nodes.size(), 0);
  for (std::size_t t = 0; t < dirty.size(); ++t)
    if (centroid(s.mesh.nodes, s.mesh.tets[t]).x < 0.3) {
      dirty[t] = 1;
      for (const std::int32_t n : s.mesh.tets[t]) near[n] = 1;
    }
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<std::uint8_t> inner = near;
    for (const Tet& t : s.mesh.tets)
      if (std::ranges::any_of(t, [&](std::int32_t n) { return inner[n] != 0; }))
        for (const std::int32_t n : t) near[n] = 1;
  }
  const auto moved_elsewhere = [&](const ImproveOptions& options) {
    const ImproveResult r = improve(s.mesh, s.supports, s.boundary, dirty, options, {});
    std::ptrdiff_t moved = 0;
    for (std::size_t n = 0; n < near.size(); ++n) moved += r.node_moved[n] != 0 && near[n] == 0;
    return moved;
  };
  EXPECT_EQ(moved_elsewhere({.threshold = 0.8, .min_dihedral = 0.7, .confined = true}), 0);
  EXPECT_GT(moved_elsewhere({.threshold = 0.8, .min_dihedral = 0.7}), 50);
}

TEST(Improve, GivesTheSameBytesForTheSameInput) {
  const SolidFixture s = make_cylinder(5, 4, 30, 7);
  const ImproveResult first = clean(s);
  const ImproveResult second = clean(s);
  EXPECT_EQ(first.mesh.tets, second.mesh.tets);
  EXPECT_EQ(first.mesh.nodes, second.mesh.nodes);
  EXPECT_EQ(first.node_moved, second.node_moved);
}

TEST(Improve, NeverMakesTheWorstTetWorse) {
  for (const double threshold : {0.1, 0.3, 0.6, 0.9}) {
    const SolidFixture s = make_box({1, 1, 1}, 7, 11);
    ImproveOptions options;
    options.threshold = threshold;
    const ImproveResult result = clean(s, options);
    EXPECT_GE(measure_quality(result.mesh.nodes, result.mesh.tets, {}).volume_length_min,
              measure_quality(s.mesh.nodes, s.mesh.tets, {}).volume_length_min)
        << "threshold " << threshold;
  }
}

TEST(Improve, OptimisesTheWorstThoughManyAreLeftWhereItIsToldTo) {
  // By this threshold most tets are bad, far more than operations are tried on.
  const SolidFixture s = make_box({4, 1, 1}, 14, 3);
  const auto worst = [&](const ImproveOptions& options) {
    const TetMesh mesh = clean(s, options).mesh;
    return measure_quality(mesh.nodes, mesh.tets, {}).volume_length_min;
  };
  EXPECT_GT(worst({.threshold = 0.8, .most_left = 1000}), worst({.threshold = 0.8}));
}

TEST(Improve, CountsWhatStaysBelowTheThreshold) {
  const SolidFixture s = make_box({1, 1, 1}, 6, 5);
  ImproveOptions options;
  options.threshold = 0.95;
  const ImproveResult result = clean(s, options);
  std::uint32_t below = 0;
  for (const Tet& t : result.mesh.tets)
    if (volume_length(result.mesh.nodes[t[0]], result.mesh.nodes[t[1]], result.mesh.nodes[t[2]],
                      result.mesh.nodes[t[3]]) < 0.95)
      ++below;
  EXPECT_GT(below, 0U);
  EXPECT_EQ(result.below_threshold, below);
}

TEST(Improve, StopsWhenAskedTo) {
  std::stop_source source;
  source.request_stop();
  remeshd::Run run;
  run.stop = source.get_token();
  const SolidFixture s = make_box({1, 1, 1}, 6, 5);
  EXPECT_THROW(improve(s.mesh, s.supports, s.boundary, s.all_dirty(), {}, run), Error);
}

/// A ball of `around` x `around` facets, all joined to one node off its middle.
SolidFixture make_star(int around) {
  SolidFixture s;
  BoundaryFace sphere;
  sphere.surface = {.kind = Surface::Kind::Sphere, .r1 = 1};
  s.boundary.faces.push_back(sphere);
  s.boundary.bounds = {{-1, -1, -1}, {1, 1, 1}};
  s.mesh.nodes = {{0, 0, 0.8}, {0, 0, -1}, {0, 0, 1}};
  const auto at = [&](int ring, int k) { return 3 + (ring - 1) * around + (k + around) % around; };
  for (int ring = 1; ring < around; ++ring)
    for (int k = 0; k < around; ++k) {
      const double polar = std::numbers::pi * ring / around,
                   angle = 2 * std::numbers::pi * k / around;
      s.mesh.nodes.push_back(
          {std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), -std::cos(polar)});
    }
  for (int k = 0; k < around; ++k) {
    s.mesh.tets.push_back({0, 1, at(1, k), at(1, k + 1)});
    s.mesh.tets.push_back({0, 2, at(around - 1, k + 1), at(around - 1, k)});
    for (int ring = 1; ring + 1 < around; ++ring) {
      s.mesh.tets.push_back({0, at(ring, k), at(ring + 1, k), at(ring, k + 1)});
      s.mesh.tets.push_back({0, at(ring, k + 1), at(ring + 1, k), at(ring + 1, k + 1)});
    }
  }
  for (Tet& t : s.mesh.tets)
    if (volume_length(s.mesh.nodes[t[0]], s.mesh.nodes[t[1]], s.mesh.nodes[t[2]],
                      s.mesh.nodes[t[3]]) < 0)
      std::swap(t[2], t[3]);
  s.supports.assign(s.mesh.nodes.size(), {Support::Kind::Face, 0});
  s.supports[0] = {};
  return s;
}

TEST(Improve, LeavesANodeAloneThatIsInHundredsOfTets) {
  for (const auto& [around, moves] : {std::pair{8, true}, {40, false}}) {
    const SolidFixture star = make_star(around);
    const ImproveResult result = clean(star);
    EXPECT_EQ(result.mesh.nodes[0] != star.mesh.nodes[0], moves) << around;
  }
}

TEST(Improve, ANodeOfAFaceThatIsInsideOfTheMeshStaysOnTheFace) {
  // As a refill may leave one. It moved freely, for no facet held it.
  SolidFixture star = make_star(8);
  BoundaryFace plane;
  plane.surface.frame = Transform::translation({0, 0, 0.8});
  star.boundary.faces.push_back(plane);
  star.supports[0] = {Support::Kind::Face, 1};
  star.mesh.nodes[0].x = 0.3;
  const ImproveResult result = clean(star);
  EXPECT_NE(result.mesh.nodes[0].x, 0.3);
  EXPECT_NEAR(result.mesh.nodes[0].z, 0.8, 1e-12);
}

}  // namespace
}  // namespace remeshd
