#include "engine/patch/same_hull.h"

#include <gtest/gtest.h>

#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// Two tets on either side of the facet 0 1 2, and three round the edge from 3 to 4 in their place.
const std::vector<Tet> kTwo{{0, 1, 2, 3}, {1, 0, 2, 4}};
const std::vector<Tet> kThree{{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}};

std::vector<bool> exchanged(const SameHull& hull, std::size_t first, std::size_t second) {
  std::vector<bool> in;
  for (std::size_t k = 0; k < first; ++k) in.push_back(hull.first(k));
  for (std::size_t k = 0; k < second; ++k) in.push_back(hull.second(k));
  return in;
}

TEST(SameHull, HoldsTetsThatFillTheSamePlace) {
  const SameHull hull({.first = kTwo, .second = kThree}, 5, kRun);
  EXPECT_EQ(exchanged(hull, 2, 3), std::vector(5, true));
}

TEST(SameHull, EndsAtTetsThatBothMeshesHave) {
  const std::vector<Tet> both{{1, 0, 5, 3}};
  const SameHull hull({.first = kThree, .second = kTwo, .both = both}, 6, kRun);
  EXPECT_EQ(exchanged(hull, 3, 2), std::vector(5, true));
}

TEST(SameHull, LeavesOutWhatMeetsATetThatStays) {
  // The tet below the facet 0 1 2 stays, and the second mesh has no such facet.
  const std::vector<Tet> two{kTwo[0]}, stays{kTwo[1]};
  const SameHull hull({.first = two, .second = kThree, .first_stay = stays}, 5, kRun);
  EXPECT_EQ(exchanged(hull, 1, 3), std::vector(4, false));
}

TEST(SameHull, LeavesOutWhatNeedsATetThatIsLeftOut) {
  // A row of three, the last of which meets a tet of the other mesh that stays.
  const std::vector<Tet> row{{0, 1, 2, 3}, {4, 2, 1, 3}, {1, 5, 4, 3}}, stays{{6, 5, 4, 3}};
  const SameHull hull({.first = row, .second_stay = stays}, 7, kRun);
  EXPECT_EQ(exchanged(hull, 3, 0), std::vector(3, false));
}

TEST(SameHull, LeavesOutTetsThatTheOtherMeshHasNoneFor) {
  const std::vector<Tet> alone{{5, 6, 7, 8}}, both{{6, 5, 7, 9}};
  std::vector<Tet> first = kTwo;
  first.push_back(alone[0]);
  const SameHull hull({.first = first, .second = kThree, .both = both}, 10, kRun);
  EXPECT_EQ(exchanged(hull, 3, 3), (std::vector{true, true, false, true, true, true}));
}

TEST(SameHull, MayDifferOnTheSurface) {
  // Two tets on a face, whose diagonal is 0 2 in the one mesh and 1 3 in the other.
  const std::vector<Tet> first{{0, 2, 1, 4}, {0, 3, 2, 4}}, second{{0, 3, 1, 4}, {1, 3, 2, 4}};
  const SameHull hull({.first = first, .second = second}, 5, kRun);
  EXPECT_EQ(exchanged(hull, 2, 2), std::vector(4, true));
}

TEST(SameHull, DoesNotLookAtFacetsOfNodesThatAreGone) {
  const std::vector<Tet> gone{{1, 0, -1, 3}, {-1, -1, -1, -1}};
  const SameHull hull({.first = kThree, .second = kTwo, .second_stay = gone}, 5, kRun);
  EXPECT_EQ(exchanged(hull, 3, 2), std::vector(5, true));
}

}  // namespace
}  // namespace remeshd
