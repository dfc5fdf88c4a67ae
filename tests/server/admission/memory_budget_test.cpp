#include "server/admission/memory_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <vector>

#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

/// Gives way by whatever is asked for.
BudgetHolder holder_of(std::uint64_t& held) {
  return {.bytes = [&held] { return held; },
          .shrink = [&held](std::uint64_t most) { held = std::min(held, most); }};
}

TEST(MemoryBudget, IsTakenByLeasesAndGivenBackByTheirEnd) {
  MemoryBudget budget(100);
  auto first = budget.try_take(60);
  EXPECT_TRUE(first);
  EXPECT_FALSE(budget.try_take(41));
  EXPECT_TRUE(budget.try_take(40));  // ends at once
  EXPECT_EQ(budget.leased(), 60U);
  EXPECT_EQ(budget.left(), 40U);
  first = {};
  EXPECT_EQ(budget.leased(), 0U);
}

TEST(MemoryBudget, ALeaseGrowsWhereThereIsRoomAndShrinksAlways) {
  MemoryBudget budget(100);
  auto lease = budget.try_take(30);
  const auto other = budget.try_take(30);
  EXPECT_FALSE(lease.try_resize(71));
  EXPECT_EQ(budget.leased(), 60U);
  EXPECT_TRUE(lease.try_resize(70));
  EXPECT_EQ(budget.left(), 0U);
  EXPECT_TRUE(lease.try_resize(10));
  EXPECT_EQ(budget.left(), 60U);
}

TEST(MemoryBudget, WhatIsThereAlreadyCountsThoughThereIsNoRoom) {
  MemoryBudget budget(100);
  std::uint64_t held = 60;
  budget.add_holder(holder_of(held));
  auto lease = budget.try_take(30);
  lease.resize(130);
  EXPECT_EQ(budget.leased(), 130U);
  EXPECT_EQ(budget.left(), 0U);
  EXPECT_EQ(held, 0U) << "the revisions held give way";
  EXPECT_FALSE(budget.try_take(1));
  lease.resize(20);
  EXPECT_TRUE(budget.try_take(80));
}

TEST(MemoryBudget, TellsWhetherWhatDoesNotGiveWayHasAllThatMayBeHeld) {
  MemoryBudget budget(100, 50);
  std::uint64_t giving = 60, staying = 49;
  budget.add_holder(holder_of(giving));
  budget.add_holder({.bytes = [&] { return staying; }, .shrink = [](auto) {}, .gives_way = false});
  std::vector<bool> heard;
  budget.on_full([&](bool full) { heard.push_back(full); });
  budget.trim();
  EXPECT_EQ(heard, std::vector{false}) << "at first, and no change since";
  staying = 50;
  budget.trim();
  budget.trim();
  staying = 10;
  budget.trim();
  EXPECT_EQ(heard, (std::vector{false, true, false}));
}

TEST(MemoryBudget, RevisionsHeldGiveWay) {
  MemoryBudget budget(100);
  std::uint64_t held = 90;
  budget.add_holder(holder_of(held));
  const auto lease = budget.try_take(30);
  EXPECT_TRUE(lease);
  EXPECT_EQ(held, 70U);
}

TEST(MemoryBudget, OfSeveralHoldersTheOneThatHasMostGivesWayFirst) {
  MemoryBudget budget(100);
  std::uint64_t a = 60, b = 20, c = 5;
  for (std::uint64_t* held : {&a, &b, &c}) budget.add_holder(holder_of(*held));
  const auto first = budget.try_take(30);
  EXPECT_TRUE(first);
  EXPECT_EQ((std::vector{a, b, c}), (std::vector<std::uint64_t>{45, 20, 5}));
  const auto second = budget.try_take(40);
  EXPECT_TRUE(second);
  EXPECT_EQ((std::vector{a, b, c}), (std::vector<std::uint64_t>{12, 12, 5}));
}

TEST(MemoryBudget, HoldersGiveWayForWhatAnotherHasInUse) {
  MemoryBudget budget(100);
  std::uint64_t idle = 40;
  budget.add_holder({.bytes = [] { return std::uint64_t{60}; }, .shrink = [](auto) {}});
  budget.add_holder(holder_of(idle));
  EXPECT_TRUE(budget.try_take(30));
  EXPECT_EQ(idle, 10U);
  EXPECT_FALSE(budget.try_take(41));
}

TEST(MemoryBudget, AHolderThatIsNoMoreIsNotAsked) {
  MemoryBudget budget(100);
  std::uint64_t a = 60;
  const auto id = budget.add_holder(holder_of(a));
  EXPECT_EQ(budget.held(), 60U);
  budget.remove_holder(id);
  EXPECT_TRUE(budget.try_take(100));
  EXPECT_EQ(budget.held(), 0U);
  EXPECT_EQ(a, 60U);
}

TEST(MemoryBudget, TheHoldersTogetherKeepToWhatTheyMayHave) {
  MemoryBudget budget(100, 50);
  std::uint64_t a = 60, b = 20;
  budget.add_holder(holder_of(a));
  budget.add_holder(holder_of(b));
  budget.trim();
  EXPECT_EQ((std::vector{a, b}), (std::vector<std::uint64_t>{30, 20}));
  const auto lease = budget.try_take(70);
  a = 25;
  budget.trim();
  EXPECT_EQ((std::vector{a, b}), (std::vector<std::uint64_t>{15, 15}));
}

TEST(MemoryBudget, GivesNothingWhereTheRevisionsHeldAreInUse) {
  MemoryBudget budget(100);
  budget.add_holder({.bytes = [] { return std::uint64_t{90}; }, .shrink = [](auto) {}});
  EXPECT_FALSE(budget.try_take(30));
  EXPECT_TRUE(budget.try_take(10));
  EXPECT_EQ(test::error_of([&] { budget.take(30, {}, 0); }).reason, "MEMORY_FULL");
}

TEST(MemoryBudget, RevisionsHeldGiveWayWhereTheProcessHasMoreThanTheEstimatesSay) {
  MemoryBudget budget(1000);
  std::uint64_t held = 600, others = 200;
  int returned = 0;
  budget.add_holder(holder_of(held));
  budget.set_process({[&] { return held + others; }, [&] { ++returned; }});
  const auto first = budget.try_take(100);
  EXPECT_EQ(held, 600U);  // 800 and 100 do fit, and leave a tenth
  EXPECT_EQ(returned, 0);
  others = 300;
  const auto second = budget.try_take(100);
  EXPECT_EQ(held + others + 100 + 100, 800U);  // and two tenths are free
  EXPECT_GT(returned, 0);
}

TEST(MemoryBudget, FreedMemoryGoesBackToTheSystemBeforeRevisionsDo) {
  MemoryBudget budget(1600);
  std::uint64_t held = 1000, freed = 600;
  budget.add_holder(holder_of(held));
  budget.set_process({[&] { return held + freed; }, [&] { freed = 0; }});
  EXPECT_TRUE(budget.try_take(100));
  EXPECT_EQ(held, 1000U);
}

TEST(MemoryBudget, AQuarterOfItIsLeftToRevisionsHowMuchElseTheProcessHas) {
  MemoryBudget budget(1600);
  std::uint64_t held = 1000;
  budget.add_holder(holder_of(held));
  budget.set_process({[&] { return held + 5000; }, [] {}});
  EXPECT_TRUE(budget.try_take(100));
  EXPECT_EQ(held, 400U);
}

TEST(MemoryBudget, WaitsForWhatOthersGiveBack) {
  MemoryBudget budget(100);
  auto lease = budget.try_take(100);
  auto next = std::async(std::launch::async, [&] { return budget.take(50, {}, 60); });
  EXPECT_EQ(next.wait_for(std::chrono::milliseconds(10)), std::future_status::timeout);
  lease = {};
  EXPECT_TRUE(next.get());
}

TEST(MemoryBudget, WaitsNoMoreOnceAskedToStop) {
  MemoryBudget budget(100);
  const auto lease = budget.try_take(100);
  std::stop_source stop;
  auto next = std::async(std::launch::async, [&] { return budget.take(50, stop.get_token(), 60); });
  stop.request_stop();
  EXPECT_FALSE(next.get());
}

TEST(MemoryBudget, RefusesForGoodWhatIsMoreThanAllOfIt) {
  MemoryBudget budget(100);
  const ErrorInfo error = test::error_of([&] { budget.take(101, {}, 60); });
  EXPECT_EQ(error.kind, ErrorKind::InvalidArgument);
  EXPECT_EQ(error.reason, "MESH_TOO_LARGE");
}

}  // namespace
}  // namespace remeshd
