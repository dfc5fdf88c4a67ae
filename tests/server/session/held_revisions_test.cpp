#include "server/session/held_revisions.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

HeldRevisionPtr revision(const std::string& id, std::size_t nodes) {
  auto held = std::make_shared<HeldRevision>();
  held->record.id = id;
  held->revision.delivery.mesh.nodes.resize(nodes);
  return held;
}

TEST(HeldRevisions, LetTheLongestUnusedGoOnceTheBudgetIsPassed) {
  HeldRevisions held(3 * memory_of(revision("", 1000)->revision), true);
  for (const char* id : {"a", "b", "c"}) held.insert(revision(id, 1000));
  EXPECT_TRUE(held.find("a"));  // used now, so `b` is the oldest
  held.insert(revision("d", 1000));
  EXPECT_TRUE(held.contains("a"));
  EXPECT_FALSE(held.contains("b"));
  EXPECT_TRUE(held.contains("c"));
  EXPECT_LE(held.bytes(), held.budget());
}

TEST(HeldRevisions, KeepEverythingWhereNothingCouldBeReadAgain) {
  HeldRevisions held(1, false);
  for (const char* id : {"a", "b", "c"}) held.insert(revision(id, 1000));
  EXPECT_EQ(held.count(), 3U);
  EXPECT_GT(held.bytes(), held.budget());
}

TEST(HeldRevisions, KeepTheNewestHoweverLarge) {
  HeldRevisions held(1, true);
  held.insert(revision("a", 10));
  held.insert(revision("b", 1000));
  EXPECT_EQ(held.count(), 1U);
  EXPECT_TRUE(held.contains("b"));
}

TEST(HeldRevisions, WhatIsInUseLivesOnAfterItWent) {
  HeldRevisions held(1, true);
  held.insert(revision("a", 10));
  const auto used = held.find("a");
  held.erase("a");
  EXPECT_EQ(held.count(), 0U);
  EXPECT_EQ(held.bytes(), 0U);
  EXPECT_EQ(used->revision.delivery.mesh.nodes.size(), 10U);
}

TEST(HeldRevisions, InsertedAgainCountOnce) {
  HeldRevisions held(1 << 20, true);
  held.insert(revision("a", 10));
  const auto bytes = held.bytes();
  held.insert(revision("a", 10));
  EXPECT_EQ(held.count(), 1U);
  EXPECT_EQ(held.bytes(), bytes);
}

}  // namespace
}  // namespace remeshd
