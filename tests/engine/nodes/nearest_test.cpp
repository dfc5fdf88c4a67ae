#include "engine/nodes/nearest.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/base/random.h"

namespace remeshd {
namespace {

std::vector<Vec3> seeded_cloud(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = {random.uniform(0, 10), random.uniform(0, 2), random.uniform(-5, 5)};
  return points;
}

std::int32_t by_hand(const std::vector<Vec3>& points, const Vec3& p) {
  std::int32_t best = -1;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (best < 0 || norm2(points[k] - p) < norm2(points[best] - p)) best = static_cast<int>(k);
  return best;
}

TEST(NearestNode, FindsWhatASearchThroughAllFinds) {
  const auto points = seeded_cloud(500, 1);
  Random random(2);
  for (const double cell : {0.05, 0.5, 3.0, 40.0}) {
    const NearestNode grid(points, cell);
    for (int k = 0; k < 500; ++k) {
      const Vec3 p{random.uniform(-5, 15), random.uniform(-5, 5), random.uniform(-9, 9)};
      const std::int32_t nearest = by_hand(points, p);
      ASSERT_EQ(grid.nearest(p), nearest) << "cell " << cell;
      for (const double radius : {0.2, 1.0, 6.0})
        ASSERT_EQ(grid.any_within(p, radius), distance(points[nearest], p) <= radius);
    }
  }
}

TEST(NearestNode, OfEquallyNearNodesTheLowestWins) {
  const std::vector<Vec3> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  EXPECT_EQ(NearestNode(points, 0.3).nearest({0, 0, 0}), 0);
}

TEST(NearestNode, AnEmptySetHasNone) {
  EXPECT_EQ(NearestNode({}, 1).nearest({0, 0, 0}), -1);
  EXPECT_FALSE(NearestNode({}, 1).any_within({0, 0, 0}, 9));
}

TEST(NearestNode, VisitsAllWithinTheRadiusAndNoOther) {
  const auto points = seeded_cloud(400, 3);
  const NearestNode grid(points, 0.7);
  const Vec3 p{4, 1, 0};
  std::set<std::int32_t> seen;
  grid.for_each_within(p, 1.5, [&](std::int32_t n, double d) {
    EXPECT_DOUBLE_EQ(d, norm2(points[n] - p));
    EXPECT_TRUE(seen.insert(n).second);
  });
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(seen.count(static_cast<int>(k)) == 1, norm2(points[k] - p) <= 1.5 * 1.5);
}

TEST(NearestNode, FollowsNodesHoweverManyMoveHoweverFar) {
  auto points = seeded_cloud(300, 4);
  NearestNode grid(points, 0.7);
  Random random(5);
  for (const double step : {0.01, 0.2, 0.001, 3.0, 0.05, 30.0, 0.1}) {
    for (const int some : {1, 3, 50}) {
      std::vector<std::int32_t> moved;
      for (int k = 0; k < some; ++k) {
        const auto n = static_cast<std::int32_t>(random.uniform() * points.size());
        for (double* x : {&points[n].x, &points[n].y, &points[n].z})
          *x += step * random.uniform(-1, 1);
        moved.push_back(n);
      }
      points.push_back({random.uniform(0, 10), random.uniform(0, 2), random.uniform(-5, 5)});
      moved.push_back(static_cast<std::int32_t>(points.size()) - 1);
      grid.follow(points, moved);
      for (int k = 0; k < 200; ++k) {
        const Vec3 p{random.uniform(-5, 15), random.uniform(-5, 5), random.uniform(-9, 9)};
        ASSERT_EQ(grid.nearest(p), by_hand(points, p)) << "steps of " << step;
        const auto any = static_cast<std::int32_t>(random.uniform(0, points.size()));
        ASSERT_EQ(grid.nearest(p, any), by_hand(points, p)) << "steps of " << step;
        ASSERT_EQ(grid.nearest(p, grid.nearest(p)), by_hand(points, p)) << "steps of " << step;
        std::size_t within = 0, counted = 0;
        for (const Vec3& q : points) within += norm2(q - p) <= 1 ? 1 : 0;
        grid.for_each_within(p, 1, [&](std::int32_t, double) { ++counted; });
        ASSERT_EQ(counted, within) << "steps of " << step;
      }
    }
  }
}

TEST(NearestNode, WithoutNodesFindsNone) {
  const NearestNode grid({}, 1);
  EXPECT_EQ(grid.nearest({4, 0, 0}), -1);
  EXPECT_FALSE(grid.any_within({4, 0, 0}, 100));
  grid.for_each_within({4, 0, 0}, 100, [](std::int32_t, double) { ADD_FAILURE(); });
}

TEST(NearestNode, FollowsTheFirstNodes) {
  NearestNode grid({}, 1);
  const std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}};
  grid.follow(points, std::vector<std::int32_t>{0, 1});
  EXPECT_EQ(grid.nearest({4, 0, 0}), 1);
}

}  // namespace
}  // namespace remeshd
