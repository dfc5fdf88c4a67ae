#include "engine/mesh/grouping.h"

#include <gmock/gmock.h>

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Grouping, GroupsKeepTheOrderInWhichTheirItemsCame) {
  const auto by_last_digit = grouped<int>(10, [](const auto& visit) {
    for (const int n : {42, 7, 12, 97, 2}) visit(n % 10, n);
  });
  EXPECT_THAT(by_last_digit[2], ElementsAre(42, 12, 2));
  EXPECT_THAT(by_last_digit[7], ElementsAre(7, 97));
  EXPECT_THAT(by_last_digit[9], IsEmpty());
  EXPECT_THAT(by_last_digit.items, ElementsAre(42, 12, 2, 7, 97));
}

TEST(Grouping, WithoutItemsAllGroupsAreEmpty) {
  const auto none = grouped<int>(2, [](const auto&) {});
  EXPECT_THAT(none[0], IsEmpty());
  EXPECT_THAT(none[1], IsEmpty());
}

TEST(SortUnique, LeavesEachValueOnceAscending) {
  std::vector<int> values{3, 1, 3, 2, 1};
  sort_unique(values);
  EXPECT_THAT(values, ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace remeshd
