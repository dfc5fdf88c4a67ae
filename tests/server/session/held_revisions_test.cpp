#include "server/session/held_revisions.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

HeldRevisionPtr held_revision(const std::string& id, std::size_t nodes) {
  auto held = std::make_shared<HeldRevision>();
  held->record.id = id;
  for (std::size_t n = 0; n < nodes; ++n)
    held->revision.output.mesh.nodes.push_back({static_cast<double>(n), 0, 0});
  return held;
}

/// The memory of nodes.
std::vector<MemoryBlock> blocks_of(const Revision& r) {
  const CowVector<Vec3>& nodes = r.output.mesh.nodes;
  std::vector<MemoryBlock> blocks;
  for (std::size_t k = 0; k < nodes.pages(); ++k)
    if (k == 0 || nodes.page(k).data() != nodes.page(k - 1).data())
      blocks.push_back({nodes.page(k).data(), nodes.page_bytes()});
  return blocks;
}

constexpr std::uint64_t kAny = 1ULL << 40;

/// What one takes.
std::uint64_t bytes_of(const HeldRevisionPtr& revision) {
  MemoryBudget budget(1);
  HeldRevisions held(budget, false, blocks_of);
  held.insert(revision);
  return held.bytes();
}

TEST(HeldRevisions, LetTheLongestUnusedGoOnceTheBudgetIsPassed) {
  MemoryBudget budget(3 * bytes_of(held_revision("", 1000)));
  HeldRevisions held(budget, true, blocks_of);
  for (const char* id : {"a", "b", "c"}) held.insert(held_revision(id, 1000));
  EXPECT_TRUE(held.find("a"));  // used now, so `b` is the oldest
  held.insert(held_revision("d", 1000));
  EXPECT_TRUE(held.contains("a"));
  EXPECT_FALSE(held.contains("b"));
  EXPECT_TRUE(held.contains("c"));
  EXPECT_LE(held.bytes(), budget.total());
}

TEST(HeldRevisions, LetThemGoWhereTheyAreMoreThanThereMayBe) {
  MemoryBudget budget(kAny, 2 * bytes_of(held_revision("", 1000)));
  HeldRevisions held(budget, true, blocks_of);
  for (const char* id : {"a", "b", "c"}) held.insert(held_revision(id, 1000));
  EXPECT_EQ(held.count(), 2U);
}

TEST(HeldRevisions, OfATenantThatFloodsGoBeforeTheFewOfAnother) {
  MemoryBudget budget(kAny, 6 * bytes_of(held_revision("", 1000)));
  HeldRevisions paced(budget, true, blocks_of), flooding(budget, true, blocks_of);
  for (const char* id : {"a", "b"}) paced.insert(held_revision(id, 1000));
  for (int n = 0; n < 20; ++n) flooding.insert(held_revision("f" + std::to_string(n), 1000));
  EXPECT_EQ(paced.count(), 2U) << "though they were used longest ago";
  EXPECT_EQ(flooding.count(), 4U);
}

TEST(HeldRevisions, KeepEverythingWhereNothingCouldBeReadAgain) {
  MemoryBudget budget(1);
  HeldRevisions held(budget, false, blocks_of);
  for (const char* id : {"a", "b", "c"}) held.insert(held_revision(id, 1000));
  EXPECT_EQ(held.count(), 3U);
  EXPECT_GT(held.bytes(), budget.total());
}

TEST(HeldRevisions, KeepTheNewestHoweverLarge) {
  MemoryBudget budget(1);
  HeldRevisions held(budget, true, blocks_of);
  held.insert(held_revision("a", 10));
  held.insert(held_revision("b", 1000));
  EXPECT_EQ(held.count(), 1U);
  EXPECT_TRUE(held.contains("b"));
}

TEST(HeldRevisions, WhatIsInUseIsNotLetGoOfForItsMemoryWouldStayTaken) {
  MemoryBudget budget(2 * bytes_of(held_revision("", 1000)));
  HeldRevisions held(budget, true, blocks_of);
  held.insert(held_revision("a", 1000));
  auto used = held.find("a");
  for (const char* id : {"b", "c", "d"}) held.insert(held_revision(id, 1000));
  EXPECT_TRUE(held.contains("a"));
  EXPECT_EQ(held.count(), 2U);
  used = nullptr;
  held.insert(held_revision("e", 1000));
  EXPECT_FALSE(held.contains("a"));
}

TEST(HeldRevisions, GiveWayToWhatTakesAShareOfTheBudget) {
  MemoryBudget budget(3 * bytes_of(held_revision("", 1000)));
  HeldRevisions held(budget, true, blocks_of);
  for (const char* id : {"a", "b", "c"}) held.insert(held_revision(id, 1000));
  const auto share = budget.try_take(2 * bytes_of(held_revision("", 1000)));
  EXPECT_TRUE(share);
  EXPECT_EQ(held.count(), 1U);
  EXPECT_TRUE(held.contains("c"));
}

TEST(HeldRevisions, WhatIsErasedWhileInUseLivesOnAndCountsUntilNobodyUsesIt) {
  MemoryBudget budget(1 << 20);
  HeldRevisions held(budget, true, blocks_of);
  held.insert(held_revision("a", 10));
  const std::uint64_t bytes = held.bytes();
  auto used = held.find("a");
  held.erase("a");
  EXPECT_EQ(held.count(), 0U);
  EXPECT_EQ(used->revision.output.mesh.nodes.size(), 10U);
  EXPECT_EQ(held.bytes(), bytes);
  used = nullptr;
  EXPECT_EQ(held.bytes(), 0U);
}

TEST(HeldRevisions, OthersGiveWayForWhatIsErasedAndInUse) {
  MemoryBudget budget(3 * bytes_of(held_revision("", 1000)));
  HeldRevisions held(budget, true, blocks_of);
  held.insert(held_revision("a", 1000));
  const auto used = held.find("a");
  held.erase("a");
  for (const char* id : {"b", "c", "d"}) held.insert(held_revision(id, 1000));
  EXPECT_EQ(held.count(), 2U);
  EXPECT_FALSE(held.contains("b"));
}

TEST(HeldRevisions, OneThatIsReplacedWhileInUseCountsBesideTheNew) {
  MemoryBudget budget(1 << 20);
  HeldRevisions held(budget, true, blocks_of);
  held.insert(held_revision("a", 10));
  const std::uint64_t bytes = held.bytes();
  auto used = held.find("a");
  held.insert(held_revision("a", 10));
  EXPECT_EQ(held.bytes(), 2 * bytes);
  used = nullptr;
  EXPECT_EQ(held.bytes(), bytes);
}

TEST(HeldRevisions, TheSameOneInsertedAgainCountsOnce) {
  MemoryBudget budget(1 << 20);
  HeldRevisions held(budget, true, blocks_of);
  const HeldRevisionPtr used = held_revision("a", 10);
  held.insert(used);
  const std::uint64_t bytes = held.bytes();
  held.insert(used);
  EXPECT_EQ(held.bytes(), bytes);
  held.erase("a");
  held.insert(used);
  EXPECT_EQ(held.bytes(), bytes);
  EXPECT_EQ(held.count(), 1U);
}

TEST(HeldRevisions, InsertedAgainCountOnce) {
  MemoryBudget budget(1 << 20);
  HeldRevisions held(budget, true, blocks_of);
  held.insert(held_revision("a", 10));
  const auto bytes = held.bytes();
  held.insert(held_revision("a", 10));
  EXPECT_EQ(held.count(), 1U);
  EXPECT_EQ(held.bytes(), bytes);
}

TEST(HeldRevisions, TheDocumentOfAnEditCounts) {
  const HeldRevisionPtr plain = held_revision("a", 10);
  auto edited = std::make_shared<HeldRevision>(*plain);
  edited->edit = std::string(5000, ' ');
  EXPECT_EQ(bytes_of(edited), bytes_of(plain) + 5000);
}

TEST(HeldRevisions, WhatTwoHaveInCommonCountsOnce) {
  HeldRevisionPtr parent = held_revision("a", 10000);
  auto heir = std::make_shared<HeldRevision>(*parent);
  heir->record.id = "b";
  heir->revision.output.mesh.nodes.edit(17) = {1, 2, 3};
  const std::size_t page = CowVector<Vec3>::page_bytes();
  MemoryBudget budget(1 << 20);
  HeldRevisions held(budget, true, blocks_of);
  held.insert(parent);
  const std::uint64_t alone = held.bytes();
  held.insert(heir);
  const std::uint64_t own = bytes_of(parent) - parent->revision.output.mesh.nodes.pages() * page;
  EXPECT_EQ(held.bytes(), alone + own + page);
  parent = nullptr;
  heir = nullptr;
  held.erase("a");
  EXPECT_EQ(held.bytes(), alone) << "what the heir has stays";
  held.erase("b");
  EXPECT_EQ(held.bytes(), 0U);
}

}  // namespace
}  // namespace remeshd
