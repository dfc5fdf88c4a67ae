#include "engine/nodes/nearest_to_points.h"

#include <gtest/gtest.h>

#include "engine/base/random.h"

namespace remeshd {
namespace {

std::int32_t nearest_by_hand(const std::vector<Vec3>& nodes, const Vec3& p) {
  std::int32_t best = -1;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (best < 0 || norm2(nodes[k] - p) < norm2(nodes[best] - p)) best = static_cast<int>(k);
  return best;
}

std::vector<Vec3> cloud_in_cube(int n, Random& random) {
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = {random.uniform(0, 10), random.uniform(0, 2), random.uniform(-5, 5)};
  return points;
}

TEST(NearestToPoints, KnowsTheNearestNodeHoweverNodesMoveAndWhicheverPointsWereAskedFor) {
  Random random(1);
  const auto points = cloud_in_cube(400, random);
  auto nodes = cloud_in_cube(300, random);
  NearestToPoints nearest(points, 0.8);
  for (const double step : {0.3, 0.1, 0.01, 2.0, 0.05, 0.02, 0.3, 0.001}) {
    for (const double share : {1.0, 0.2, 0.01, 0.0}) {
      for (Vec3& n : nodes)
        if (random.uniform() < share)
          for (double* x : {&n.x, &n.y, &n.z}) *x += step * random.uniform(-1, 1);
      if (share == 0.2) nodes.push_back(points[17] + Vec3{step, 0, 0});
      nearest.follow(nodes);
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        if (random.uniform() < 0.3) continue;
        ASSERT_EQ(nearest.nearest(p), nearest_by_hand(nodes, points[p])) << step << " " << share;
      }
    }
  }
}

TEST(NearestToPoints, OfEquallyNearNodesTheLowestWinsAlsoWhereItComesLater) {
  std::vector<Vec3> nodes{{9, 9, 9}, {0.5, 0, 0}, {5, 5, 5}, {6, 6, 6}, {7, 7, 7}};
  NearestToPoints nearest({{0, 0, 0}}, 1);
  nearest.follow(nodes);
  EXPECT_EQ(nearest.nearest(0), 1);
  nodes[0] = {-0.5, 0, 0};
  nearest.follow(nodes);
  EXPECT_EQ(nearest.nearest(0), 0);
}

TEST(NearestToPoints, WithoutNodesHasNone) {
  NearestToPoints nearest({{0, 0, 0}}, 1);
  nearest.follow({});
  EXPECT_EQ(nearest.nearest(0), -1);
}

}  // namespace
}  // namespace remeshd
