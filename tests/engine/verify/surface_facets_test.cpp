#include "engine/verify/surface_facets.h"
#include "tests/support/run.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace remeshd {
namespace {

using test::kRun;

FacetMatch matched(const std::vector<Tet>& tets) {
  Polling poll(kRun);
  return match_facets(CowVector<Tet>(tets), 20, poll);
}

std::vector<std::int32_t> tets_of(const std::vector<SurfaceFacet>& surface) {
  std::vector<std::int32_t> tets;
  for (const SurfaceFacet& f : surface) tets.push_back(f.tet);
  return tets;
}

TEST(MatchFacets, LeavesTheFacetsOfOneTetOnly) {
  const FacetMatch match = matched({{0, 1, 2, 3}, {0, 2, 1, 4}});
  EXPECT_TRUE(match.clashes.empty());
  EXPECT_EQ(tets_of(match.surface), (std::vector<std::int32_t>{0, 0, 0, 1, 1, 1}));
  for (const SurfaceFacet& f : match.surface)
    EXPECT_TRUE(std::ranges::count(f.nodes, 3) + std::ranges::count(f.nodes, 4) == 1);
}

TEST(MatchFacets, TellsApartFacetsThatShareTwoNodesAndABucket) {
  // Facets (0, 1, k) of a fan, two of which have other nodes that are alike but for a multiple
  // of 8.
  const FacetMatch match = matched({{0, 1, 2, 10}, {0, 1, 10, 18}, {0, 1, 18, 3}});
  EXPECT_TRUE(match.clashes.empty());
  EXPECT_EQ(match.surface.size(), 8U);
}

TEST(MatchFacets, NamesTheTetThatTurnsAsItsNeighbourDoes) {
  EXPECT_EQ(matched({{0, 1, 2, 3}, {0, 1, 2, 4}}).clashes, std::vector<std::int32_t>{1});
}

TEST(MatchFacets, NamesEachTetBeyondTheSecond) {
  EXPECT_EQ(matched({{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}, {0, 2, 1, 6}}).clashes,
            (std::vector<std::int32_t>{2, 3}));
}

TEST(MatchFacets, ClashesComeByTheSmallestNodeOfTheirFacet) {
  const FacetMatch match = matched({{5, 6, 7, 8}, {5, 6, 7, 9}, {1, 2, 3, 4}, {1, 2, 3, 10}});
  EXPECT_EQ(match.clashes, (std::vector<std::int32_t>{3, 1}));
}

}  // namespace
}  // namespace remeshd
