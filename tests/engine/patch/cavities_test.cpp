#include "engine/patch/cavities.h"
#include "tests/support/run.h"

#include <gtest/gtest.h>

#include <utility>

namespace remeshd {
namespace {

using test::kRun;

// The second and third tet share a facet and have been replaced by one that has their nodes but for
// one; the fourth stands alone.
const std::vector<Tet> kDelaunay{{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}, {10, 11, 12, 13}};
const std::vector<Tet> kDelivered{{11, 10, 13, 12}, {0, 1, 2, 3}, {1, 2, 3, 5}};

void expect_pieces(const Cavities& cavities) {
  EXPECT_EQ(cavities.same, (std::vector<std::int32_t>{1, -1, -1, 0}));
  EXPECT_EQ(cavities.of_tet, (std::vector<std::int32_t>{-1, 0, 0, -1}));
  ASSERT_EQ(cavities.list.size(), 1U);
  EXPECT_EQ(cavities.list[0].delaunay, (std::vector<std::int32_t>{1, 2}));
  EXPECT_EQ(cavities.list[0].output, (std::vector<std::int32_t>{2}));
}

TEST(Cavities, StandForThemselvesOrInClusters) {
  expect_pieces(find_cavities(kDelaunay, kDelivered, {}, 14, CavityExtent::Connected, kRun));
}

TEST(Cavities, AreTheSameWhateverIsKnownOfThem) {
  using Known = std::vector<std::int32_t>;
  for (const Known& same : {Known{-1, -1, -1}, Known{3, -1, -1}, Known{-1, 0, -1}, Known{3, 0, -1}})
    expect_pieces(find_cavities(kDelaunay, kDelivered, same, 14, CavityExtent::Connected, kRun));
}

TEST(Cavities, HoldTetsThatANodeHasMovedAcross) {
  const std::vector<Tet> delaunay{{0, 1, 2, 3}}, output{{1, 0, 2, 3}};
  const Cavities cavities = find_cavities(delaunay, output, {}, 4, CavityExtent::Least, kRun);
  EXPECT_EQ(cavities.same[0], -1);
  ASSERT_EQ(cavities.list.size(), 1U);
  EXPECT_EQ(cavities.list[0].output, (std::vector<std::int32_t>{0}));
}

/// A tet of positive volume.
Tet upright(const std::vector<Vec3>& p, Tet t) {
  if (dot(p[t[1]] - p[t[0]], cross(p[t[2]] - p[t[0]], p[t[3]] - p[t[0]])) < 0)
    std::swap(t[0], t[1]);
  return t;
}

TEST(Cavities, OfTheLeastExtentEndAtFacetsThatBothMeshesHave) {
  // Two bipyramids with the facet 0 1 3 in common; in each, two tets became three.
  const std::vector<Vec3> p{{1, 0, 0},  {-0.5, 0.87, 0}, {-0.5, -0.87, 0}, {0, 0, 1},
                            {0, 0, -1}, {1, 1.6, 0.3},   {0.7, 1.2, -1}};
  std::vector<Tet> delaunay{{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 5, 3}, {0, 1, 5, 6}};
  std::vector<Tet> output{{3, 4, 0, 1}, {3, 4, 1, 2}, {3, 4, 2, 0},
                          {3, 6, 0, 1}, {3, 6, 1, 5}, {3, 6, 5, 0}};
  for (Tet& t : delaunay) t = upright(p, t);
  for (Tet& t : output) t = upright(p, t);
  const Cavities connected = find_cavities(delaunay, output, {}, 7, CavityExtent::Connected, kRun);
  EXPECT_EQ(connected.list.size(), 1U);
  const Cavities least = find_cavities(delaunay, output, {}, 7, CavityExtent::Least, kRun);
  EXPECT_EQ(least.of_tet, (std::vector<std::int32_t>{0, 0, 1, 1}));
  ASSERT_EQ(least.list.size(), 2U);
  EXPECT_EQ(least.list[0].output, (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(least.list[1].output, (std::vector<std::int32_t>{3, 4, 5}));
}

// A last resort may fill what no Delaunay tet of the model does.
TEST(Cavities, OfNoDelaunayTetGetOne) {
  const std::vector<Tet> delaunay{{0, 1, 2, 3}, {4, 5, 6, 7}};
  const std::vector<Tet> output{{0, 1, 2, 3}, {4, 5, 6, 7}, {5, 6, 8, 9}, {20, 21, 22, 23}};
  const Cavities cavities = find_cavities(delaunay, output, {}, 24, CavityExtent::Connected, kRun);
  EXPECT_EQ(cavities.same, (std::vector<std::int32_t>{-1, -1}));
  EXPECT_EQ(cavities.of_tet, (std::vector<std::int32_t>{0, 1}));
  ASSERT_EQ(cavities.list.size(), 2U);
  EXPECT_EQ(cavities.list[0].output, (std::vector<std::int32_t>{0, 3}));
  EXPECT_EQ(cavities.list[1].output, (std::vector<std::int32_t>{1, 2}));
}

}  // namespace
}  // namespace remeshd
