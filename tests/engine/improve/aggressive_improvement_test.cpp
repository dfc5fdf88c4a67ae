#include "engine/improve/aggressive_improvement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/boundary/edge_chains.h"
#include "engine/improve/improve.h"
#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

using test::make_box;
using test::make_cylinder;
using test::SolidFixture;

constexpr double kLeastMeasure = 0.52, kLeastAngle = 25.2 * std::numbers::pi / 180;

/// A solid whose model edges have twice the nodes that their surroundings want: each of their tets
/// has a short edge, and no node of the chain can make room alone.
SolidFixture crowded(SolidFixture s) {
  const auto chains = edge_chains(s.boundary, s.supports, s.mesh.nodes);
  for (std::size_t e = 0; e < chains.size(); ++e)
    for (std::size_t i = 0; i + 1 < chains[e].size(); ++i) {
      const Vec3 middle =
          0.5 * (s.mesh.nodes[chains[e][i].node] + s.mesh.nodes[chains[e][i + 1].node]);
      s.add(project(s.boundary, s.boundary.edges[e], middle), Support::Kind::Edge,
            static_cast<int>(e));
    }
  s.mesh.tets.clear();
  s.triangulate([](const Vec3&) { return true; });
  return s;
}

struct Workshop {
  explicit Workshop(const SolidFixture& s)
      : mesh(s.mesh),
        rules(s.boundary, s.supports, mesh, 0.05),
        smoother(mesh, rules),
        last(mesh, rules, smoother, score, 8) {}

  [[nodiscard]] double worst(const std::vector<std::int32_t>& tets) const {
    double w = 1;
    for (const std::int32_t t : tets) w = std::min(w, score(mesh, t));
    return w;
  }

  /// Of the whole mesh.
  [[nodiscard]] double worst() const {
    std::vector<std::int32_t> all;
    for (std::int32_t t = 0; t < mesh.slots(); ++t)
      if (mesh.used(t)) all.push_back(t);
    return worst(all);
  }

  LocalMesh mesh;
  Score score{kLeastMeasure, kLeastAngle};
  BoundaryRules rules;
  Smoother smoother;
  AggressiveImprovement last;
};

TEST(Score, IsOneAtTheGoalsAndLessForASharpTetOfAFairMeasure) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0.5, 0.9, 0}, d{0.5, 0.3, 0.8};
  const double measure = volume_length(a, b, c, d);
  const auto angles = dihedral_angles(a, b, c, d);
  const double least = *std::min_element(angles.begin(), angles.end());
  EXPECT_NEAR(Score(measure, 0.1)(a, b, c, d), 1, 1e-12);
  const Vec3 low{0.5, 0.3, 0.25};
  const double low_measure = volume_length(a, b, c, low);
  const auto low_angles = dihedral_angles(a, b, c, low);
  const double low_least = *std::min_element(low_angles.begin(), low_angles.end());
  ASSERT_LT(low_least, least);
  EXPECT_NEAR(Score(0.5 * low_measure, low_least)(a, b, c, low), 1, 1e-12);
  EXPECT_LT(Score(0.5 * low_measure, 1.1 * low_least)(a, b, c, low), 1);
  EXPECT_LT(Score(0.5, 0.4)(a, c, b, d), 0) << "inverted";
}

TEST(Score, HasMoreEnergyTheSharperATetAndInfiniteOnceItIsInverted) {
  const Score score(kLeastMeasure, kLeastAngle);
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0.5, 0.9, 0};
  double last = 0;
  for (const double height : {0.8, 0.5, 0.3, 0.2}) {
    const double energy = score.energy(a, b, c, {0.5, 0.3, height}, 3);
    EXPECT_GT(energy, last) << "height " << height;
    last = energy;
  }
  EXPECT_EQ(score.energy(a, b, c, {0.5, 0.3, -0.8}, 3), HUGE_VAL);
}

TEST(AggressiveImprovement, MendATetOrLeaveTheMeshAsItWas) {
  const SolidFixture s = crowded(make_box({1, 1, 1}, 5, 6, 0.3));
  Workshop w(s);
  int mended = 0, left = 0;
  for (std::int32_t t = 0; t < w.mesh.slots(); ++t) {
    if (!w.mesh.used(t) || w.score(w.mesh, t) >= 1) continue;
    const TetMesh before = w.mesh.result();
    const double worst = w.worst();
    if (w.last.optimise_neighbourhood(t)) {
      ++mended;
      EXPECT_FALSE(w.last.touched().empty());
      EXPECT_GE(w.worst(), worst);
    } else {
      ++left;
      EXPECT_EQ(w.mesh.result().tets, before.tets);
      EXPECT_EQ(w.mesh.result().nodes, before.nodes);
    }
  }
  EXPECT_GT(mended, 0);
  EXPECT_GT(left, 0);
}

TEST(AggressiveImprovement, ACompassSearchSaysWhetherItMovedANode) {
  const SolidFixture s = crowded(make_box({1, 1, 1}, 5, 6, 0.3));
  Workshop w(s);
  int moved = 0, left = 0;
  for (std::int32_t t = 0; t < w.mesh.slots(); ++t) {
    const std::vector<Vec3> before = w.mesh.result().nodes;
    const double worst = w.worst();
    const bool says_so = w.last.compass_search(t);
    EXPECT_EQ(says_so, w.mesh.result().nodes != before) << t;
    EXPECT_GE(w.worst(), worst) << t;
    ++(says_so ? moved : left);
  }
  EXPECT_GT(moved, 0);
  EXPECT_GT(left, 0);
}

TEST(AggressiveImprovement, TakeATetOutAtAPriceWhereMotionAloneDoesNotHelp) {
  const SolidFixture s = crowded(make_box({1, 1, 1}, 5, 6, 0.3));
  Workshop w(s);
  int helped = 0;
  for (std::int32_t t = 0; t < w.mesh.slots(); ++t) {
    if (!w.mesh.used(t) || w.score(w.mesh, t) >= 1 || w.last.optimise_neighbourhood(t)) continue;
    const TetMesh before = w.mesh.result();
    const double worst = w.worst();
    if (w.last.perturb_and_optimise(t)) {
      ++helped;
      EXPECT_GE(w.worst(), worst);
    } else {
      EXPECT_EQ(w.mesh.result().tets, before.tets);
      EXPECT_EQ(w.mesh.result().nodes, before.nodes);
    }
  }
  EXPECT_GT(helped, 0);
}

TEST(AggressiveImprovement, ReconnectSharpTetsOfAFairMeasure) {
  const SolidFixture s = make_box({2, 1, 1}, 14, 1);
  Workshop w(s);
  int found = 0;
  for (std::int32_t t = 0; t < w.mesh.slots(); ++t) {
    if (!w.mesh.used(t) || w.mesh.quality(t) < kLeastMeasure) continue;
    const double score = w.score(w.mesh, t);
    if (score >= 1 || !w.last.reconnect(t)) continue;
    ++found;
    EXPECT_GT(w.worst(w.last.touched()), score);
  }
  EXPECT_GT(found, 0);
}

TEST(AggressiveImprovement, ReachTheGoalsWhereModelEdgesAreCrowded) {
  const SolidFixture solids[] = {crowded(make_box({1, 1, 1}, 5, 6, 0.3)),
                                 crowded(make_box({1, 1, 1}, 8, 6)),
                                 crowded(make_cylinder(5, 4, 36, 11))};
  for (const SolidFixture& s : solids) {
    const ImproveResult result =
        improve(s.mesh, s.supports, s.boundary, s.all_dirty(), {}, remeshd::Run{});
    EXPECT_EQ(result.below_threshold, 0U);
    EXPECT_GE(measure_quality(result.mesh.nodes, result.mesh.tets, {}).dihedral_min, 25.19);
  }
}

}  // namespace
}  // namespace remeshd
