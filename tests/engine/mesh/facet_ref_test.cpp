#include "engine/mesh/facet_ref.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <type_traits>

namespace remeshd {
namespace {

constexpr std::int32_t kLastTet = std::numeric_limits<std::int32_t>::max() / 4;

// Millions lie in arrays, which are stored as they lie in memory.
static_assert(std::is_trivial_v<FacetRef> && sizeof(FacetRef) == sizeof(std::int32_t));

TEST(FacetRef, TellsTetAndCorner) {
  for (const std::int32_t tet : {0, 1, 41, kLastTet})
    for (const int corner : {0, 1, 2, 3}) {
      const FacetRef facet(tet, corner);
      EXPECT_TRUE(facet.is_tet());
      EXPECT_FALSE(facet.is_none() || facet.is_beyond());
      EXPECT_EQ(facet.tet(), tet);
      EXPECT_EQ(facet.corner(), corner);
    }
}

TEST(FacetRef, NoneIsNoTetsAndNotBeyond) {
  EXPECT_TRUE(FacetRef::none().is_none());
  EXPECT_FALSE(FacetRef::none().is_tet() || FacetRef::none().is_beyond());
  EXPECT_LT(FacetRef::none().tet(), 0);
}

TEST(FacetRef, BeyondAPatchHasANumber) {
  for (const std::int32_t k : {0, 1, 2, 3, 4, 1000000}) {
    const FacetRef facet = FacetRef::beyond(k);
    EXPECT_TRUE(facet.is_beyond());
    EXPECT_FALSE(facet.is_tet() || facet.is_none());
    EXPECT_EQ(facet.exterior(), k);
    EXPECT_LT(facet.tet(), 0);
  }
}

TEST(FacetRef, IsStoredAsItAlwaysWas) {
  EXPECT_EQ(FacetRef(7, 2).code(), 30);
  EXPECT_EQ(FacetRef::none().code(), -1);
  EXPECT_EQ(FacetRef::beyond(0).code(), -2);
  EXPECT_EQ(FacetRef::beyond(5).code(), -7);
}

TEST(FacetRef, ComesInTheOrderOfTetsThenCorners) {
  EXPECT_LT(FacetRef::beyond(1), FacetRef::beyond(0));
  EXPECT_LT(FacetRef::beyond(0), FacetRef::none());
  EXPECT_LT(FacetRef::none(), FacetRef(0, 0));
  EXPECT_LT(FacetRef(3, 1), FacetRef(3, 2));
  EXPECT_LT(FacetRef(3, 3), FacetRef(4, 0));
  EXPECT_EQ(FacetRef(3, 2), FacetRef(3, 2));
}

}  // namespace
}  // namespace remeshd
