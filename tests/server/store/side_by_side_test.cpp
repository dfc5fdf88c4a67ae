#include "server/store/side_by_side.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace remeshd::test {
namespace {

TEST(SideBySide, DoesEachJobOnce) {
  std::vector<std::atomic<int>> done(100);
  std::vector<std::function<void()>> jobs;
  for (std::atomic<int>& count : done) jobs.emplace_back([&count] { ++count; });
  do_side_by_side(jobs);
  for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
}

TEST(SideBySide, DoesAllThoughSomeFailAndThrowsWhatTheFirstOfThemThrew) {
  std::atomic<int> done = 0;
  std::vector<std::function<void()>> jobs;
  for (int k = 0; k < 20; ++k)
    jobs.emplace_back([&done, k] {
      ++done;
      if (k % 7 == 6) throw std::runtime_error(std::to_string(k));
    });
  try {
    do_side_by_side(jobs);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& failure) {
    EXPECT_STREQ(failure.what(), "6");
  }
  EXPECT_EQ(done, 20);
}

TEST(SideBySide, NoJobsAreNoWork) { EXPECT_NO_THROW(do_side_by_side({})); }

}  // namespace
}  // namespace remeshd::test
