#include "engine/base/parallel.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>

namespace remeshd {
namespace {

Run on(int threads) {
  Run run;
  run.threads = threads;
  return run;
}

TEST(Parallel, BlocksCoverTheRangeOnceWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5})
    for (const std::size_t count : {0, 1, 7, 8, 9, 1000}) {
      std::vector<int> visits(count, 0);
      in_blocks(count, 8, on(threads), [&](std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin % 8, 0U);
        EXPECT_LE(end - begin, 8U);
        for (std::size_t k = begin; k < end; ++k) ++visits[k];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " on " << threads;
    }
}

TEST(Parallel, WhatBlocksFindComesInTheirOrder) {
  for (const int threads : {1, 2, 5}) {
    const auto found = collect_in_blocks<int>(
        100, 3, on(threads), [](std::size_t begin, std::size_t end, std::vector<int>& out) {
          for (std::size_t k = begin; k < end; ++k)
            if (k % 7 == 0) out.push_back(static_cast<int>(k));
        });
    EXPECT_EQ(found, (std::vector<int>{0, 7, 14, 21, 28, 35, 42, 49, 56, 63, 70, 77, 84, 91, 98}));
    EXPECT_TRUE(collect_in_blocks<int>(0, 3, on(threads), [](auto...) {}).empty());
  }
}

TEST(Parallel, ThrowsWhatTheFirstBlockThrew) {
  for (const int threads : {1, 2, 5}) {
    std::string what;
    try {
      in_blocks(64, 1, on(threads), [](std::size_t begin, std::size_t) {
        if (begin >= 5) throw std::runtime_error(std::to_string(begin));
      });
    } catch (const std::runtime_error& e) {
      what = e.what();
    }
    EXPECT_EQ(what, "5") << threads;
  }
}

TEST(Parallel, BlocksMayHaveBlocks) {
  std::vector<std::size_t> sums(20);
  in_blocks(sums.size(), 1, on(3), [&](std::size_t k, std::size_t) {
    std::vector<std::size_t> part(50);
    in_blocks(part.size(), 4, on(3), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) part[i] = k * i;
    });
    sums[k] = std::accumulate(part.begin(), part.end(), std::size_t{0});
  });
  for (std::size_t k = 0; k < sums.size(); ++k) EXPECT_EQ(sums[k], k * 1225);
}

TEST(Parallel, TasksAreAllDone) {
  for (const int threads : {1, 2}) {
    int a = 0, b = 0;
    side_by_side({[&] { a = 1; }, [&] { b = 2; }}, on(threads));
    EXPECT_EQ(a + b, 3);
  }
}

}  // namespace
}  // namespace remeshd
