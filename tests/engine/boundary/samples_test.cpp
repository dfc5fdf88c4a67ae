#include "engine/boundary/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/nearest.h"
#include "engine/sizing/size_rules.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

struct Sampled {
  FeatureModel model;
  CellularModel cells;
  Membership membership;
  Samples samples;
};

Sampled sample(const std::string& name, double edge_length, std::uint64_t seed = 1,
               const SampleOptions& options = {}) {
  FeatureModel model = test::case_features(name);
  CellularModel cells = build_cells(model, kRun);
  Membership membership(model);
  Samples samples = sample_boundary(cells.boundary, membership, edge_length, seed, options, kRun);
  return {std::move(model), std::move(cells), std::move(membership), std::move(samples)};
}

TEST(Samples, WeightsAddUpToAreasAndLengths) {
  const Sampled s = sample("tool2-d", 3);
  std::map<int, double> area, length;
  for (const Sample& p : s.samples.points) {
    if (p.support.kind == Support::Kind::Face) area[p.support.entity] += p.weight;
    if (p.support.kind == Support::Kind::Edge) length[p.support.entity] += p.weight;
  }
  const BoundaryModel& b = s.cells.boundary;
  ASSERT_EQ(area.size(), b.faces.size());
  ASSERT_EQ(length.size(), b.edges.size());
  for (const auto& [f, a] : area) EXPECT_NEAR(a, b.faces[f].area, 1e-9 * b.faces[f].area);
  for (const auto& [e, l] : length) EXPECT_NEAR(l, b.edges[e].length, 1e-9 * b.edges[e].length);
}

TEST(Samples, FollowASizeFieldAndStillAddUp) {
  const FeatureModel model = test::case_features("tool1-a");
  const CellularModel cells = build_cells(model, kRun);
  const BoundaryModel& b = cells.boundary;
  const SizeField sizes = SizeRules(b, {.even = false}, 8, {}).field(8, 1);
  ASSERT_LT(sizes.least(), 3);
  const Samples samples = sample_boundary(b, Membership(model), sizes, 1, {}, kRun);
  std::vector<double> area(b.faces.size(), 0), length(b.edges.size(), 0);
  for (const Sample& s : samples.points) {
    const double h = sizes(s.position);
    if (s.support.kind == Support::Kind::Face) {
      area[s.support.entity] += s.weight;
      ASSERT_GT(s.weight, 0.4 * 0.36 * 0.36 * h * h);
      ASSERT_LT(s.weight, 2.5 * 0.36 * 0.36 * h * h);
    } else if (s.support.kind == Support::Kind::Edge) {
      length[s.support.entity] += s.weight;
      ASSERT_LT(s.weight, 1.3 * 0.18 * h);
    }
  }
  for (std::size_t f = 0; f < area.size(); ++f)
    EXPECT_NEAR(area[f], b.faces[f].area, 1e-9 * b.faces[f].area);
  for (std::size_t e = 0; e < length.size(); ++e)
    EXPECT_NEAR(length[e], b.edges[e].length, 1e-9 * b.edges[e].length);
}

TEST(Samples, LieOnTheirEntityAndOnTheBoundary) {
  const Sampled s = sample("tool1-a", 3);
  for (const Sample& p : s.samples.points) {
    ASSERT_LT(distance(project(s.cells.boundary, p.support, p.position), p.position), 1e-9);
    if (p.support.kind != Support::Kind::Face) continue;
    const BoundaryFace& f = s.cells.boundary.faces[p.support.entity];
    const Vec3 out = (f.reversed ? -1.0 : 1.0) * normal(f.surface, p.position);
    ASSERT_TRUE(s.membership.inside(p.position - 1e-6 * out));
    ASSERT_FALSE(s.membership.inside(p.position + 1e-6 * out));
  }
}

TEST(Samples, CoverEveryFaceWithoutHoles) {
  const double l = 3;
  const Sampled s = sample("tool3-a", l);
  std::vector<Vec3> positions;
  for (const Sample& p : s.samples.points) positions.push_back(p.position);
  const NearestNode grid(positions, l);
  for (const BoundaryFace& f : s.cells.boundary.faces)
    for (const auto& t : f.triangles) {
      const Vec3 c = project(f.surface, (f.points[t[0]] + f.points[t[1]] + f.points[t[2]]) / 3.0);
      EXPECT_LT(distance(positions[grid.nearest(c)], c), 0.4 * l);
    }
}

TEST(Samples, AboutSevenStandForOneBoundaryNode) {
  const Sampled s = sample("tool1-a", 2.4);
  const double per_node = s.samples.edges_begin / (s.cells.area / (0.866 * 2.4 * 2.4));
  EXPECT_GT(per_node, 5.5);
  EXPECT_LT(per_node, 8.5);
}

TEST(Samples, ComeInTheOrderFacesEdgesVertices) {
  const Sampled s = sample("fig11-a", 4);
  for (std::size_t k = 0; k < s.samples.points.size(); ++k)
    EXPECT_EQ(s.samples.points[k].support.kind, k < s.samples.edges_begin ? Support::Kind::Face
                                                : k < s.samples.vertices_begin
                                                    ? Support::Kind::Edge
                                                    : Support::Kind::Vertex);
}

TEST(Samples, AreAsDenseWhereTheyAreWantedAndNowhereElse) {
  const double l = 3;
  const Sampled all = sample("tool3-a", l);
  // Regions that overlap, the second in two parts.
  const Vec3 a = all.samples.points.front().position, b = a + Vec3{3 * l, 0, 0};
  const Vec3 c = all.samples.points[all.samples.edges_begin / 2].position;
  const std::vector<Region> places{Region(std::vector<Vec3>{a}, 4 * l, 3),
                                   Region(std::vector<Vec3>{b, c}, 4 * l, 1)};
  const auto wanted = [&](const Vec3& p) { return places[0].holds(p) || places[1].holds(p); };
  const Sampled some = sample("tool3-a", l, 1, {.where = places});
  std::vector<Vec3> positions;
  for (const Sample& s : some.samples.points) {
    EXPECT_TRUE(wanted(s.position));
    positions.push_back(s.position);
  }
  const auto expected = std::ranges::count_if(all.samples.points,
                                              [&](const Sample& s) { return wanted(s.position); });
  ASSERT_GT(expected, 300);
  EXPECT_NEAR(positions.size(), expected, 0.1 * static_cast<double>(expected));
  // None twice where the regions overlap.
  const NearestNode grid(positions, l);
  for (std::size_t k = 0; k < some.samples.edges_begin; ++k) {
    int close = 0;
    grid.for_each_within(positions[k], 0.05 * l, [&](std::int32_t n, double) {
      close += static_cast<std::size_t>(n) < some.samples.edges_begin ? 1 : 0;
    });
    EXPECT_LE(close, 2);  // itself, and that of another face at most
  }
}

TEST(Samples, TheSeedDecidesThem) {
  const Sampled a = sample("simple-a", 5, 1), b = sample("simple-a", 5, 1),
                c = sample("simple-a", 5, 2);
  EXPECT_EQ(a.samples.points.front().position, b.samples.points.front().position);
  EXPECT_NE(a.samples.points.front().position, c.samples.points.front().position);
}

}  // namespace
}  // namespace remeshd
