#include "server/store/catalogue.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

namespace remeshd {
namespace {

RevisionRecord record(const std::string& id) {
  return {.id = id,
          .parent = "p",
          .model_name = "m\n\"\xC3\xA4",
          .created_ns = 5,
          .nodes = 7,
          .tets = 8,
          .mid_nodes = 9,
          .bytes = 9};
}

std::string rows(Catalogue& catalogue) {
  std::string text;
  for (const DesignRecord& design : catalogue.designs({}, {}))
    text +=
        design.name + " next " + std::to_string(design.next_number) + " head " + design.head + "\n";
  for (const ListedRevision& row : catalogue.list({}, {}))
    text += row.place.design + "@" + std::to_string(row.place.number) + " " + row.record.id + "\n";
  return text;
}

TEST(Catalogue, ATransactionHappensAsAWholeOrNotAtAll) {
  Catalogue catalogue;
  catalogue.apply({AddRevision{record("aa")}, AddPlace{"d", 1, "aa"}, SetHead{"d", "aa"}});
  const std::string before = rows(catalogue);
  // The number is taken: the revision before it must not stay.
  EXPECT_THROW(catalogue.apply({AddRevision{record("bb")}, AddPlace{"d", 1, "bb"}}), Error);
  EXPECT_FALSE(catalogue.revision("bb"));
  EXPECT_EQ(catalogue.revision("aa"), record("aa"));
  EXPECT_EQ(rows(catalogue), before);
}

TEST(Catalogue, WhatIsOnlyCheckedDoesNotHappen) {
  Catalogue catalogue;
  catalogue.check({AddRevision{record("aa")}, AddPlace{"d", 1, "aa"}});
  EXPECT_FALSE(catalogue.revision("aa"));
  EXPECT_EQ(rows(catalogue), "");
}

TEST(Catalogue, AConflictIsFoundByACheck) {
  Catalogue catalogue;
  catalogue.apply({AddPlace{"d", 1, "aa"}});
  EXPECT_THROW(catalogue.check({AddPlace{"d", 1, "bb"}}), Error);
}

TEST(Catalogue, ATransactionMayBeAppliedAgain) {
  Catalogue catalogue;
  const Transaction transaction{AddRevision{record("aa")}, AddPlace{"d", 1, "aa"},
                                SetHead{"d", "aa"}};
  catalogue.apply(transaction);
  const std::string once = rows(catalogue);
  catalogue.apply(transaction);
  EXPECT_EQ(rows(catalogue), once);
  const Transaction removal{RemovePlace{"d", 1}, RemoveRevision{"aa"}, SetHead{"d", ""}};
  catalogue.apply(removal);
  catalogue.apply(removal);
  EXPECT_EQ(rows(catalogue), "d next 2 head \n");
}

TEST(Catalogue, OfManyTransactionsThoseThatFailAreLeftOut) {
  Catalogue catalogue;
  EXPECT_EQ(catalogue.apply_all({{AddRevision{record("aa")}, AddPlace{"d", 1, "aa"}},
                                 {AddRevision{record("bb")}, AddPlace{"d", 1, "bb"}},
                                 {AddRevision{record("cc")}, AddPlace{"d", 2, "cc"}}}),
            1U);
  EXPECT_TRUE(catalogue.revision("aa"));
  EXPECT_FALSE(catalogue.revision("bb"));
  EXPECT_TRUE(catalogue.revision("cc"));
}

TEST(Catalogue, NextNumbersOnlyGrow) {
  Catalogue catalogue;
  catalogue.apply({AddPlace{"d", 5, "aa"}, AddPlace{"d", 2, "bb"}});
  EXPECT_EQ(catalogue.design("d")->next_number, 6U);
  catalogue.apply({RemovePlace{"d", 5}, RemovePlace{"d", 2}});
  EXPECT_EQ(catalogue.design("d")->next_number, 6U);
  EXPECT_EQ(catalogue.design("d")->revisions, 0U);
}

TEST(Catalogue, ItsSnapshotMakesItAgain) {
  Catalogue catalogue;
  catalogue.apply({AddRevision{record("aa")}, AddPlace{"e", 3, "aa"}, AddPlace{"d", 1, "aa"},
                   SetHead{"e", "aa"}});
  catalogue.apply({AddRevision{record("bb")}, AddPlace{"d", 7, "bb"}, SetHead{"d", "bb"}});
  catalogue.apply({AddRevision{record("cc")}});
  catalogue.apply({RemovePlace{"d", 7}, SetHead{"d", "aa"}, RemoveRevision{"bb"}});
  Catalogue again;
  again.apply({AddRevision{record("zz")}, AddPlace{"z", 1, "zz"}});  // which it replaces
  EXPECT_EQ(again.apply_all(catalogue.snapshot()), 0U);
  EXPECT_EQ(rows(again), rows(catalogue));
  EXPECT_EQ(again.places("aa"), catalogue.places("aa"));  // in the order in which it got there
  EXPECT_EQ(again.revision("cc"), record("cc"));
  EXPECT_FALSE(again.revision("zz"));
  EXPECT_EQ(again.design("d")->next_number, 8U);
}

TEST(Catalogue, KeepsTheRecipesOfDeletedAncestorsUnderTheirIdsUntilNothingNeedsThem) {
  const std::string first = std::string(62, '0') + "fa", second(64, 'e');
  RevisionRecord root = record(first), edited = record(second);
  root.parent = "";
  edited.parent = first;
  Catalogue catalogue;
  catalogue.apply({AddRevision{root, {"one"}}});
  catalogue.apply({AddRevision{edited, {"two"}}});
  catalogue.apply({RemoveRevision{first}});
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  const Pairs both{{first, ""}, {second, first}};
  EXPECT_EQ(catalogue.recipes(), both);
  catalogue.set_recipe_places({{first, {.start = 5, .length = 6}}});
  Catalogue again;
  EXPECT_EQ(again.apply_all(catalogue.snapshot()), 0U);
  EXPECT_EQ(again.recipes(), both);
  EXPECT_EQ(again.recipe(first), KeptRecipe(JournalPlace{.start = 5, .length = 6}));
  EXPECT_EQ(again.recipe(second), KeptRecipe("two"));
  again.apply({RemoveRevision{second}});
  EXPECT_TRUE(again.recipes().empty());
}

TEST(Catalogue, PrefixesFindEveryIdThatBeginsWithThem) {
  Catalogue catalogue;
  for (const char* id : {"abc0", "abcf", "abd0", "ab"}) catalogue.apply({AddRevision{record(id)}});
  EXPECT_EQ(catalogue.with_prefix("abc", 9), (std::vector<std::string>{"abc0", "abcf"}));
  EXPECT_EQ(catalogue.with_prefix("abcf", 9), std::vector<std::string>{"abcf"});
  EXPECT_TRUE(catalogue.with_prefix("ac", 9).empty());
}

}  // namespace
}  // namespace remeshd
