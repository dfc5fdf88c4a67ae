#include "server/admission/fair_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace remeshd {
namespace {

constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum_under(const std::vector<std::uint64_t>& amounts, std::uint64_t cap) {
  std::uint64_t sum = 0;
  for (const std::uint64_t amount : amounts) sum += std::min(amount, cap);
  return sum;
}

TEST(FairCap, IsNoneWhereEverythingFits) {
  EXPECT_EQ(fair_cap({}, 0), kAny);
  EXPECT_EQ(fair_cap({0, 0}, 0), kAny);
  EXPECT_EQ(fair_cap({10, 20, 30}, 60), kAny);
}

TEST(FairCap, OfOneIsAllThereIs) { EXPECT_EQ(fair_cap({70}, 60), 60U); }

TEST(FairCap, TakesFromTheOneThatHasMost) {
  EXPECT_EQ(fair_cap({10, 20, 30}, 59), 29U);
  EXPECT_EQ(fair_cap({1000, 10, 10}, 60), 40U);
}

TEST(FairCap, TakesFromTheNextOnceItHasNoMoreThanThat) {
  EXPECT_EQ(fair_cap({1000, 30, 10}, 60), 25U);
  EXPECT_EQ(fair_cap({1000, 30, 10}, 9), 3U);
  EXPECT_EQ(fair_cap({1000, 30, 10}, 0), 0U);
}

TEST(FairCap, FitsAndOneMoreWouldNot) {
  std::mt19937 random(1);
  for (int round = 0; round < 1000; ++round) {
    std::vector<std::uint64_t> amounts(1 + random() % 6);
    for (std::uint64_t& amount : amounts) amount = random() % 20;
    const std::uint64_t total = random() % 60;
    const std::uint64_t cap = fair_cap(amounts, total);
    EXPECT_LE(sum_under(amounts, cap), total);
    if (cap != kAny) {
      EXPECT_GT(sum_under(amounts, cap + 1), total);
    }
  }
}

}  // namespace
}  // namespace remeshd
