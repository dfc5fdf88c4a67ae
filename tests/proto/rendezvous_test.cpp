#include "proto/rendezvous.h"

#include <gmock/gmock.h>

namespace remeshd::test {
namespace {

using testing::ElementsAre;

TEST(Rendezvous, RanksAsEveryClientDoes) {
  // By Python: sorted(range(3), key=lambda i: sha256(f"{a[i]}\n{route}".encode()).digest(),
  // reverse=True)
  const std::vector<std::string> addresses{"10.0.0.1:50051", "10.0.0.2:50051", "10.0.0.3:50051"};
  EXPECT_THAT(rank_by_rendezvous(addresses, "plate"), ElementsAre(2, 1, 0));
  EXPECT_THAT(rank_by_rendezvous(addresses, "bracket"), ElementsAre(2, 1, 0));
  EXPECT_EQ(first_by_rendezvous({"only"}, "plate"), 0U);
}

TEST(Rendezvous, MovesTheRoutesOfAnAddressThatGoesAndNoOthers) {
  const std::vector<std::string> three{"a", "b", "c"}, two{"a", "b"};
  int moved = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string route = "design " + std::to_string(i);
    const std::size_t before = first_by_rendezvous(three, route);
    if (before == 2) {
      ++moved;
    } else {
      EXPECT_EQ(first_by_rendezvous(two, route), before);
    }
  }
  EXPECT_NEAR(moved, 100, 40);
}

}  // namespace
}  // namespace remeshd::test
