#include "server/session/disk_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

namespace remeshd {
namespace {

/// What a tenant has stored.
struct Stored {
  explicit Stored(std::uint64_t b) : bytes(b) {}
  BudgetHolder holder() {
    return {.bytes = [this] { return bytes.load(); },
            .shrink = [this](std::uint64_t most) { bytes = std::min(bytes.load(), most); }};
  }
  /// Whether it comes to be so many within 10 s.
  [[nodiscard]] bool comes_to(std::uint64_t wanted) const {
    for (int k = 0; k < 10000 && bytes != wanted; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return bytes == wanted;
  }
  std::atomic<std::uint64_t> bytes;
};

TEST(DiskBudget, TakesFromTheTenantThatHasMost) {
  Stored a(70), b(20), c(40);
  DiskBudget budget(100);
  for (Stored* each : {&a, &b, &c}) budget.add_holder(each->holder());
  EXPECT_EQ(budget.cap(), 40U);
  budget.look_soon();
  EXPECT_TRUE(a.comes_to(40));
  EXPECT_EQ(b.bytes, 20U);
  EXPECT_EQ(c.bytes, 40U);
}

TEST(DiskBudget, OfNoLimitTakesNothing) {
  Stored a(1ULL << 60);
  DiskBudget budget(0);
  budget.add_holder(a.holder());
  budget.look_soon();
  EXPECT_EQ(budget.cap(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(a.bytes, 1ULL << 60);
}

TEST(DiskBudget, WhatATenantCannotLetGoOfCostsTheOthersNothing) {
  Stored pinned(90), b(40);
  std::atomic<int> asked = 0;
  DiskBudget budget(100);
  budget.add_holder(
      {.bytes = [&] { return pinned.bytes.load(); }, .shrink = [&](auto) { ++asked; }});
  budget.add_holder(b.holder());
  budget.look_soon();
  for (int k = 0; k < 10000 && asked == 0; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(budget.cap(), 60U);  // which waits for the round to end
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(b.bytes, 40U);
}

TEST(DiskBudget, AFailureOfOneTenantsStoreHidesNothingFromTheOthers) {
  Stored b(80);
  DiskBudget budget(100);
  budget.add_holder({.bytes = [] { return std::uint64_t{90}; },
                     .shrink = [](auto) { throw std::runtime_error("its disk fails"); }});
  budget.add_holder(b.holder());
  budget.look_soon();
  EXPECT_TRUE(b.comes_to(50));
}

}  // namespace
}  // namespace remeshd
