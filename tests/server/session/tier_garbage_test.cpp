#include "server/session/tier_garbage.h"

#include <gmock/gmock.h>

#include <limits>

#include "server/tier/sealed_object.h"
#include "tests/server/session/farm.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr auto kAny = std::numeric_limits<std::uint64_t>::max();
constexpr double kDay = 86400;  // s

/// `a` stands alone, `b` on it, `c` on that; `x` alone; written in this order, of 10 bytes each.
std::vector<SharedObject> objects() {
  return {{.id = "a", .bytes = 10, .written_ns = 1},
          {.id = "b", .needs = "a", .bytes = 10, .written_ns = 2},
          {.id = "x", .bytes = 10, .written_ns = 3},
          {.id = "c", .needs = "b", .bytes = 10, .written_ns = 4}};
}
std::vector<std::string> dropped(const std::vector<SharedObject>& all, std::uint64_t bytes,
                                 std::optional<std::int64_t> after = std::nullopt) {
  std::vector<std::string> ids;
  for (const SharedObject& object : dropped_objects(all, kept_objects(all, bytes, after)))
    ids.push_back(object.id);
  return ids;
}

TEST(TierGarbage, TheNewestStayWithAllThatTheyNeed) {
  EXPECT_THAT(dropped(objects(), kAny), IsEmpty());
  EXPECT_THAT(dropped(objects(), 40), IsEmpty());
  EXPECT_THAT(dropped(objects(), 39), ElementsAre("x"));
  EXPECT_THAT(dropped(objects(), 29), UnorderedElementsAre("a", "b", "c", "x"))
      << "what is no use alone does not stay alone";
}

TEST(TierGarbage, WhatWasNotWrittenForLongGoesUnlessItIsNeeded) {
  EXPECT_THAT(dropped(objects(), kAny, 4), ElementsAre("x"));
  EXPECT_THAT(dropped(objects(), kAny, 5), testing::SizeIs(4));
}

TEST(TierGarbage, WhatIsPinnedStaysWhateverItTakes) {
  auto all = objects();
  all[1].pinned = true;
  EXPECT_THAT(dropped(all, 0), ElementsAre("c", "x"));
}

TEST(TierGarbage, NothingIsThereWithoutWhatItNeedsAtAnyMoment) {
  const auto order = dropped(objects(), 0);
  const auto at = [&](const char* id) { return std::ranges::find(order, id) - order.begin(); };
  EXPECT_LT(at("c"), at("b"));
  EXPECT_LT(at("b"), at("a"));
}

TEST(TierGarbage, ACircleOfStrangersEnds) {
  std::vector<SharedObject> all{{.id = "a", .needs = "b", .bytes = 1},
                                {.id = "b", .needs = "a", .bytes = 1}};
  EXPECT_EQ(kept_objects(all, 1, std::nullopt).size(), 0U);
  EXPECT_EQ(dropped(all, 0).size(), 2U);
}

/// A tier with a loop in it.
class TierGarbageTest : public FarmTest {
 protected:
  TierGarbageTest() {
    open(here_);
    ids_ = make_chain(here_);
    here_.settle();
  }
  Collected collect(const GarbageOptions& options) {
    return here_.session->cache().collect_tier_garbage(options);
  }
  /// Another daemon has all of it right, and made that many.
  void expect_served(int made) {
    open(there_);
    for (const std::string& id : ids_) EXPECT_EQ(there_.served(id), here_.served(id));
    EXPECT_EQ(there_.engine.made(), made);
  }
  std::vector<std::string> ids_;
};

TEST_F(TierGarbageTest, MeshesGoAndAreMadeAgainOfTheirRecipes) {
  const Collected would = collect({.disk_bytes = 0, .dry_run = true});
  EXPECT_EQ(shelf_->keys().size(), 8U);
  const Collected did = collect({.disk_bytes = 0});
  EXPECT_EQ(did.meshes, 4U);
  EXPECT_EQ(did.meshes, would.meshes);
  EXPECT_EQ(did.bytes_freed, would.bytes_freed);
  EXPECT_THAT(shelf_->keys("pack/"), IsEmpty());
  EXPECT_EQ(shelf_->keys("recipe/").size(), 4U);
  expect_served(4);
}

TEST_F(TierGarbageTest, AMeshThatOthersAreToldByStaysWithThem) {
  shelf_->age(10 * kDay);
  const std::string last = here_.make(edit_of(ids_[3], 84)).filed.record.id;
  here_.settle();
  const std::string key = shelf_->keys("pack/" + last.substr(0, 2) + "/" + last).at(0);
  const std::string pack = unsealed(key, *shelf_->get(key, {}), kFarmKey);
  ASSERT_NE(Packs::head_in(pack)->record.base, "");
  collect({.unused_seconds = kDay});
  open(there_);
  EXPECT_EQ(there_.served(last), here_.served(last));
  EXPECT_EQ(there_.engine.made(), 0);
}

TEST_F(TierGarbageTest, AMeshThatADaemonPinnedStays) {
  open(there_);
  there_.session->cache().set_pin(ids_[3], true);
  collect({.disk_bytes = 0});
  EXPECT_THAT(shelf_->keys("pack/"), testing::Contains(testing::HasSubstr(ids_[3])));
  there_.session->cache().set_pin(ids_[3], false);
  collect({.disk_bytes = 0});
  EXPECT_THAT(shelf_->keys("pack/"), IsEmpty());
}

TEST_F(TierGarbageTest, RecipesGoAWeekAfterTheyWereFound) {
  shelf_->age(100 * kDay);
  const GarbageOptions all{.disk_bytes = 0, .recipes_unused_seconds = 30 * kDay};
  EXPECT_EQ(collect(all).recipes, 0U);
  shelf_->age(6 * kDay);
  EXPECT_EQ(collect(all).recipes, 0U);
  shelf_->age(2 * kDay);
  EXPECT_EQ(collect(all).recipes, 4U);
  EXPECT_THAT(shelf_->keys(), IsEmpty());
}

TEST_F(TierGarbageTest, ARecipeThatSomethingNewIsMadeOfStays) {
  shelf_->age(100 * kDay);
  const GarbageOptions all{.disk_bytes = 0, .recipes_unused_seconds = 30 * kDay};
  collect(all);
  shelf_->age(8 * kDay);
  here_.make(edit_of(ids_[1], 90));  // which another daemon might do by now
  here_.settle();
  EXPECT_EQ(collect(all).recipes, 2U);
  EXPECT_EQ(shelf_->keys("recipe/").size(), 3U);
  EXPECT_THAT(shelf_->keys("doomed/"), IsEmpty());
}

TEST_F(TierGarbageTest, WithoutATierThereIsNothingToCollect) {
  open(there_, Sharing{});
  EXPECT_EQ(error_of([&] { there_.session->cache().collect_tier_garbage({}); }).reason,
            "OPTIONS_INVALID");
}

}  // namespace
}  // namespace remeshd::test
