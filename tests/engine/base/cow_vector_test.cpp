#include "engine/base/cow_vector.h"

#include <gtest/gtest.h>

#include <numeric>
#include <ranges>
#include <thread>

namespace remeshd {
namespace {

using Numbers = CowVector<int>;
static_assert(std::random_access_iterator<Numbers::Iterator>);
constexpr std::size_t kPage = Numbers::kPage;

std::vector<int> count_up(std::size_t size) {
  std::vector<int> values(size);
  std::iota(values.begin(), values.end(), 0);
  return values;
}

std::size_t shared(const Numbers& a, const Numbers& b) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < a.pages(); ++k) count += a.shares(k, b) ? 1 : 0;
  return count;
}

TEST(CowVector, HoldTheirValuesInOrder) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kPage - 1, kPage, 3 * kPage + 7}) {
    const std::vector<int> values = count_up(size);
    const Numbers pages(values);
    EXPECT_EQ(pages.size(), size);
    EXPECT_EQ(pages.flat(), values);
    EXPECT_TRUE(std::ranges::equal(pages, values));
    EXPECT_TRUE(std::ranges::equal(std::views::reverse(pages), std::views::reverse(values)));
    std::vector<int> by_page;
    for (std::size_t k = 0; k < pages.pages(); ++k)
      by_page.insert(by_page.end(), pages.page(k).begin(), pages.page(k).end());
    EXPECT_EQ(by_page, values);
  }
}

TEST(CowVector, CopiesShareAllButWhatIsWrittenTo) {
  const Numbers original(count_up(5 * kPage));
  Numbers copy = original;
  EXPECT_EQ(shared(copy, original), 5U);
  copy.edit(2 * kPage + 3) = -1;
  EXPECT_EQ(shared(copy, original), 4U);
  EXPECT_FALSE(copy.shares(2, original));
  EXPECT_EQ(copy[2 * kPage + 3], -1);
  EXPECT_EQ(copy[2 * kPage + 4], original[2 * kPage + 4]);
  EXPECT_EQ(original.flat(), count_up(5 * kPage));
  EXPECT_FALSE(copy == original);
  copy.edit(2 * kPage + 3) = original[2 * kPage + 3];
  EXPECT_EQ(copy, original);
}

TEST(CowVector, WritingWhatStandsThereCopiesNothing) {
  const Numbers original(count_up(3 * kPage));
  Numbers copy = original;
  for (std::size_t k = 0; k < copy.size(); ++k) copy.set(k, static_cast<int>(k));
  EXPECT_EQ(shared(copy, original), 3U);
  copy.set(kPage, 7);
  EXPECT_EQ(copy[kPage], 7);
  EXPECT_EQ(original[kPage], static_cast<int>(kPage));
}

TEST(CowVector, GrowAndShrinkLikeAVector) {
  std::vector<int> expected;
  Numbers pages;
  int value = 0;
  for (const std::size_t size : {kPage / 2, 4 * kPage + 1, kPage, 2 * kPage, kPage - 3, 5 * kPage,
                                 std::size_t{0}, std::size_t{5}}) {
    const Numbers before = pages;
    const std::vector<int> then = expected;
    pages.resize(size, ++value);
    expected.resize(size, value);
    EXPECT_EQ(pages.flat(), expected);
    EXPECT_EQ(before.flat(), then);
    if (size > 0) {
      pages.edit(size - 1) = expected[size - 1] = -value;
      EXPECT_EQ(pages.flat(), expected);
    }
  }
  pages.push_back(17);
  EXPECT_EQ(pages[pages.size() - 1], 17);
}

TEST(CowVector, OfOneValueStandInMemoryOnce) {
  Numbers pages(4 * kPage, 3);
  EXPECT_EQ(pages.page(0).data(), pages.page(3).data());
  pages.edit(0) = 1;
  EXPECT_EQ(pages[0], 1);
  EXPECT_EQ(pages[3 * kPage], 3);
}

TEST(CowVector, APageThatIsWrittenToIsOfOneCopyAlone) {
  const Numbers original(count_up(2 * kPage + 5));
  Numbers copy = original;
  const std::span<int> last = copy.edit_page(2);
  ASSERT_EQ(last.size(), 5U);
  std::ranges::fill(last, -1);
  EXPECT_EQ(copy[2 * kPage], -1);
  EXPECT_EQ(original.flat(), count_up(2 * kPage + 5));
  EXPECT_TRUE(copy.shares(1, original));
  EXPECT_FALSE(copy.shares(2, original));
  EXPECT_EQ(copy.edit_page(2).data(), last.data());
  copy.resize(2 * kPage + 7, 4);
  EXPECT_EQ(copy[2 * kPage + 4], -1);
  EXPECT_EQ(copy[2 * kPage + 6], 4);
}

TEST(CowVector, AreWrittenToAloneHoweverManyCopiesGo) {
  const Numbers original(count_up(8 * kPage));
  std::vector<std::thread> threads;
  std::vector<int> sums(4, 0);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int round = 0; round < 50; ++round) {
        Numbers copy = original;
        for (std::size_t k = 0; k < copy.size(); k += kPage / 2) copy.edit(k) = t;
        const Numbers grandchild = copy;
        copy = original;
        for (std::size_t k = 0; k < copy.size(); k += kPage / 2) sums[t] += grandchild[k] - t;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(sums, std::vector<int>(4, 0));
  EXPECT_EQ(original.flat(), count_up(8 * kPage));
}

}  // namespace
}  // namespace remeshd
