#include "server/store/listing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/store/catalogue.h"

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Rows = std::vector<std::string>;

/// Three revisions in two designs, of which one is in both, and one in none.
class ListingTest : public testing::Test {
 protected:
  ListingTest() {
    RevisionRecord first{.id = "aa", .root = "aa", .model_name = "m", .algorithm_version = 1};
    first.created_ns = 30;
    first.nodes = 100;
    RevisionRecord edited = first;
    edited.id = "bb";
    edited.parent = "aa";
    edited.created_ns = 20;
    edited.algorithm_version = 2;
    RevisionRecord other = first;
    other.id = other.root = "cc";
    other.model_name = "n";
    other.created_ns = 10;
    other.nodes = 50;
    RevisionRecord alone = other;
    alone.id = "dd";
    catalogue_.apply({AddRevision{first}, AddPlace{"plate", 1, "aa"}, AddRevision{edited},
                      AddPlace{"plate", 2, "bb"}, SetHead{"plate", "bb"}, AddRevision{other},
                      AddPlace{"hub", 1, "cc"}, AddPlace{"hub", 2, "aa"}, SetHead{"hub", "cc"},
                      AddRevision{alone}});
    catalogue_.apply({AddDesign{.name = "hub", .changed_ns = 7}});
    catalogue_.apply({AddDesign{.name = "pipe", .changed_ns = 25}});
  }

  static std::string name(const ListedRevision& row) {
    return row.place.design + "@" + std::to_string(row.place.number) + " " + row.record.id;
  }
  Rows list(const RevisionFilter& filter, const RevisionPage& page = {}) {
    Rows rows;
    for (const ListedRevision& row : catalogue_.list(filter, page)) rows.push_back(name(row));
    return rows;
  }
  Rows designs(const DesignFilter& filter, const DesignPage& page = {}) {
    Rows rows;
    for (const DesignRecord& row : catalogue_.designs(filter, page)) rows.push_back(row.name);
    return rows;
  }

  Catalogue catalogue_;
};

TEST_F(ListingTest, RevisionsStandByDesignAndNumber) {
  EXPECT_THAT(list({}), ElementsAre("hub@1 cc", "hub@2 aa", "plate@1 aa", "plate@2 bb"));
  EXPECT_THAT(list({}, {.descending = true}),
              ElementsAre("plate@2 bb", "plate@1 aa", "hub@2 aa", "hub@1 cc"));
}

TEST_F(ListingTest, RevisionsStandByTimeOrNodesThenIdAndDesign) {
  EXPECT_THAT(list({}, {.order = RevisionOrder::Created}),
              ElementsAre("hub@1 cc", "plate@2 bb", "hub@2 aa", "plate@1 aa"));
  EXPECT_THAT(list({}, {.order = RevisionOrder::Nodes}),
              ElementsAre("hub@1 cc", "hub@2 aa", "plate@1 aa", "plate@2 bb"));
}

TEST_F(ListingTest, WhatIsSetInAFilterMustHold) {
  EXPECT_THAT(list({.design = "plate"}), ElementsAre("plate@1 aa", "plate@2 bb"));
  EXPECT_THAT(list({.model_name = "n"}), ElementsAre("hub@1 cc"));
  EXPECT_THAT(list({.parent = "aa"}), ElementsAre("plate@2 bb"));
  EXPECT_THAT(list({.root = "aa"}), ElementsAre("hub@2 aa", "plate@1 aa", "plate@2 bb"));
  EXPECT_THAT(list({.heads = true}), ElementsAre("hub@1 cc", "plate@2 bb"));
  EXPECT_THAT(list({.unfiled = true}), ElementsAre("@0 dd"));
  EXPECT_THAT(list({.created_from_ns = 20, .created_before_ns = 30}), ElementsAre("plate@2 bb"));
  EXPECT_THAT(list({.algorithm_version = 2}), ElementsAre("plate@2 bb"));
  EXPECT_THAT(list({.design = "hub", .root = "aa", .heads = true}), IsEmpty());
}

TEST_F(ListingTest, PagesOfAnyOrderFollowOnEachOther) {
  for (const RevisionOrder order :
       {RevisionOrder::Place, RevisionOrder::Created, RevisionOrder::Nodes})
    for (const bool descending : {false, true}) {
      RevisionPage page{.order = order, .descending = descending};
      const Rows whole = list({}, page);
      Rows paged;
      page.limit = 1;
      for (auto rows = catalogue_.list({}, page); !rows.empty(); rows = catalogue_.list({}, page)) {
        paged.push_back(name(rows.back()));
        page.after = key_of(rows.back(), order);
      }
      EXPECT_EQ(paged, whole);
    }
}

TEST_F(ListingTest, DesignsStandByNameChangeOrNumberOfRevisions) {
  EXPECT_THAT(designs({}), ElementsAre("hub", "pipe", "plate"));
  // Nobody told when `plate` changed: as its newest revision.
  EXPECT_THAT(designs({}, {.order = DesignOrder::Changed}), ElementsAre("hub", "pipe", "plate"));
  EXPECT_THAT(designs({}, {.order = DesignOrder::Changed, .descending = true}),
              ElementsAre("plate", "pipe", "hub"));
  EXPECT_THAT(designs({}, {.order = DesignOrder::Revisions}), ElementsAre("pipe", "hub", "plate"));
  EXPECT_THAT(designs({.prefix = "p"}), ElementsAre("pipe", "plate"));
  EXPECT_THAT(designs({.prefix = "%"}), IsEmpty());
  EXPECT_THAT(designs({.changed_from_ns = 8, .changed_before_ns = 30}), ElementsAre("pipe"));
}

TEST_F(ListingTest, PagesOfDesignsFollowOnEachOther) {
  for (const DesignOrder order : {DesignOrder::Name, DesignOrder::Changed, DesignOrder::Revisions})
    for (const bool descending : {false, true}) {
      DesignPage page{.order = order, .descending = descending};
      const Rows whole = designs({}, page);
      Rows paged;
      page.limit = 1;
      for (auto rows = catalogue_.designs({}, page); !rows.empty();
           rows = catalogue_.designs({}, page)) {
        paged.push_back(rows.back().name);
        page.after = key_of(rows.back(), order);
      }
      EXPECT_EQ(paged, whole);
    }
}

TEST_F(ListingTest, ADesignOffTheListKeepsItsNumbers) {
  catalogue_.apply({RemovePlace{"hub", 1}, RemovePlace{"hub", 2}, SetHead{"hub", ""},
                    AddDesign{.name = "hub", .listed = false}});
  EXPECT_THAT(designs({}), ElementsAre("pipe", "plate"));
  EXPECT_FALSE(catalogue_.design("hub"));
  EXPECT_EQ(catalogue_.count_designs(), 2U);
  EXPECT_EQ(catalogue_.next_number("hub"), 3U);
  Catalogue again;
  EXPECT_EQ(again.apply_all(catalogue_.snapshot()), 0U);
  EXPECT_FALSE(again.design("hub"));
  EXPECT_EQ(again.next_number("hub"), 3U);
  catalogue_.apply({AddPlace{"hub", 3, "aa"}});
  EXPECT_EQ(catalogue_.design("hub")->next_number, 4U);
}

}  // namespace
}  // namespace remeshd
