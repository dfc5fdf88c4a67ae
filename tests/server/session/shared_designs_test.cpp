#include "server/session/shared_designs.h"

#include <gmock/gmock.h>

#include "proto/rendezvous.h"
#include "tests/server/designs/design_shelf.h"
#include "tests/server/session/farm.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

using testing::ElementsAre;

/// Two replicas with a table of designs in common.
class SharedDesignsTest : public FarmTest {
 protected:
  SharedDesignsTest() {
    table_ = designs_;
    open(here_);
    open(there_);
  }
  /// `name@head of REVISIONS` of all designs.
  static std::vector<std::string> designs(const Replica& replica) {
    std::vector<std::string> texts;
    for (const DesignRecord& design : replica.session->designs({}, {}))
      texts.push_back(design.name + "@" + std::to_string(design.head_number) + " of " +
                      std::to_string(design.revisions));
    return texts;
  }
  static std::string reason(const std::function<void()>& work) { return error_of(work).reason; }

  const std::shared_ptr<DesignShelf> designs_ = std::make_shared<DesignShelf>();
};

TEST_F(SharedDesignsTest, AnyReplicaKnowsNamesAndHeads) {
  const auto ids = make_chain(here_);
  here_.settle();
  EXPECT_THAT(designs(there_), ElementsAre("plate@4 of 4"));
  EXPECT_EQ(there_.session->resolve("plate").id, ids[3]);
  EXPECT_EQ(there_.session->resolve("plate@2").id, ids[1]);
  EXPECT_EQ(there_.session->list({.design = "plate"}, {}).size(), 4U);
  EXPECT_EQ(there_.served(ids[1]), here_.served(ids[1]));
  EXPECT_EQ(there_.engine.made(), 0);
}

TEST_F(SharedDesignsTest, AnyReplicaFilesAndMovesTheHead) {
  const auto ids = make_chain(here_);
  here_.settle();
  const Made made = there_.make(edit_of("plate", 90));
  EXPECT_EQ(made.filed.place.number, 5U);
  EXPECT_EQ(made.filed.record.parent, ids[3]);
  EXPECT_THAT(designs(here_), ElementsAre("plate@5 of 5"));
  here_.session->set_head("plate@2", "", made.filed.record.id);
  EXPECT_EQ(there_.session->resolve("plate").id, ids[1]);
  EXPECT_EQ(reason([&] { there_.session->set_head("plate@3", "", ids[0]); }), "HEAD_CONFLICT");
}

TEST_F(SharedDesignsTest, WhoComesSecondGetsTheNextNumberAndDoesNotMoveTheHead) {
  const std::string first = here_.make(first_mesh()).filed.record.id;
  here_.settle();
  Made other;
  designs_->before_change = [&] { other = there_.make(edit_of("plate", 90)); };
  const Made made = here_.make(edit_of("plate", 81));
  EXPECT_EQ(other.filed.place.number, 2U);
  EXPECT_TRUE(other.filed.place.head);
  EXPECT_EQ(made.filed.place.number, 3U);
  EXPECT_TRUE(made.filed.head_conflict);
  EXPECT_EQ(made.filed.head, other.filed.record.id);
  EXPECT_THAT(designs(here_), ElementsAre("plate@2 of 3"));
  EXPECT_EQ(designs(there_), designs(here_));
}

TEST_F(SharedDesignsTest, WhatRequiresAHeadThatMovesMeanwhileFailsAndIsFiledNowhere) {
  here_.make(first_mesh());
  here_.settle();
  EditCommand command = std::get<EditCommand>(edit_of("plate", 81));
  command.head.require = true;
  designs_->before_change = [&] { there_.make(edit_of("plate", 90)); };
  EXPECT_EQ(here_.fail(command).reason, "HEAD_CONFLICT");
  EXPECT_THAT(designs(here_), ElementsAre("plate@2 of 2"));
}

TEST_F(SharedDesignsTest, NothingIsLostWhileTheTableIsOut) {
  const std::string id = here_.make(first_mesh()).filed.record.id;
  here_.settle();
  designs_->fails = true;
  const ErrorInfo why = here_.fail(edit_of(id, 81));
  EXPECT_EQ(why.reason, "CATALOGUE_UNAVAILABLE");
  EXPECT_EQ(why.kind, ErrorKind::Unavailable);
  EXPECT_GT(why.retry_after.value_or(0), 0);
  EXPECT_EQ(reason([&] { here_.session->resolve("plate"); }), "CATALOGUE_UNAVAILABLE");
  EditCommand by_id = std::get<EditCommand>(edit_of(id, 81));
  by_id.head.file = false;
  EXPECT_EQ(here_.fail(by_id).reason, "") << "loops by id go on";
  EXPECT_EQ(here_.session->describe(here_.session->resolve(id), kRun).places.size(), 1U);
  designs_->fails = false;
  EXPECT_EQ(here_.make(edit_of(id, 81)).filed.place.number, 2U);
  EXPECT_EQ(here_.engine.made(), 2);
}

TEST_F(SharedDesignsTest, WhatWasMadeIsKeptWhereTheTableFailsAtTheEnd) {
  here_.make(first_mesh());
  here_.engine.close_gate();
  Answer answer;
  here_.session->make(edit_of("plate", 81), answer.listener());
  ASSERT_TRUE(here_.engine.wait_at_gate(1));
  designs_->fails = true;
  here_.engine.open_gate();
  EXPECT_EQ(answer.error().reason, "CATALOGUE_UNAVAILABLE");
  designs_->fails = false;
  const Made made = here_.make(edit_of("plate", 81));
  EXPECT_TRUE(made.cached);
  EXPECT_EQ(made.filed.place.number, 2U);
}

TEST_F(SharedDesignsTest, WhatIsRemovedIsRemovedForAll) {
  const auto ids = make_chain(here_);
  here_.settle();
  designs(there_);
  there_.session->remove("plate@2", false);
  EXPECT_EQ(reason([&] { here_.session->resolve("plate@2"); }), "REVISION_NOT_FOUND");
  EXPECT_THAT(designs(here_), ElementsAre("plate@4 of 3"));
  there_.session->remove(ids[2], false);
  EXPECT_THAT(designs(here_), ElementsAre("plate@4 of 2"));
  here_.session->remove_design("plate", "");
  EXPECT_THAT(designs(there_), ElementsAre());
  EXPECT_EQ(there_.make(first_mesh()).filed.place.number, 5U) << "numbers go on";
  EXPECT_THAT(designs(here_), ElementsAre("plate@5 of 1"));
}

TEST_F(SharedDesignsTest, AStoreFromBeforeEntersItsDesigns) {
  open(here_, Sharing{});
  const auto ids = make_chain(here_);
  open(here_);
  EXPECT_THAT(designs(here_), ElementsAre("plate@4 of 4"));
  EXPECT_EQ(there_.session->resolve("plate@3").id, ids[2]);
}

TEST_F(SharedDesignsTest, ATableThatWasLostIsFilledAgain) {
  make_chain(here_);
  designs_->lose();
  EXPECT_EQ(here_.make(edit_of("plate", 90)).filed.place.number, 5U);
  EXPECT_THAT(designs(there_), ElementsAre("plate@5 of 5"));
}

TEST_F(SharedDesignsTest, OneThatWasSetBackIsRight) {
  make_chain(here_);
  const auto state = designs_->since("", "plate", 0);
  here_.make(edit_of("plate", 90));
  designs_->lose();
  DesignState back = state;
  ASSERT_TRUE(designs_->change("", {{.name = "plate", .to = back}}));
  EXPECT_THAT(designs(here_), ElementsAre("plate@4 of 4"));
}

TEST_F(SharedDesignsTest, TenantsAreApart) {
  here_.make(first_mesh());
  Store store(StoreFolder().path());
  SharedDesigns of_another(designs_, "another", store);
  of_another.refresh_all();
  EXPECT_EQ(store.read([](Catalogue& catalogue) { return catalogue.count_designs(); }), 0U);
}

TEST_F(SharedDesignsTest, ManyWritersLoseNoNumber) {
  const std::string id = here_.make(first_mesh()).filed.record.id;
  here_.settle();
  const auto write = [&](const Replica& replica, int from) {
    for (int i = 0; i < 20; ++i) replica.make(edit_of(id, from + i));
  };
  std::thread other([&] { write(there_, 200); });
  write(here_, 100);
  other.join();
  EXPECT_THAT(designs(here_), ElementsAre(testing::HasSubstr("of 41")));
  EXPECT_EQ(designs(there_), designs(here_));
}

/// Replicas that have no table: each design is at one of them.
class HomesTest : public FarmTest {
 protected:
  HomesTest() {
    Sharing shared = sharing();
    shared.homes = {.replicas = {"a:1", "b:1"}, .own = "a:1"};
    // By the SHA-256 of both addresses with the name.
    home_is_here_ = first_by_rendezvous(shared.homes.replicas, "plate") == 0;
    open(home_is_here_ ? here_ : there_, shared);
    shared.homes.own = "b:1";
    open(home_is_here_ ? there_ : here_, shared);
  }
  bool home_is_here_ = false;  ///< of `plate`
};

TEST_F(HomesTest, ADesignIsAtItsHomeAlone) {
  const std::string home = home_is_here_ ? "a:1" : "b:1";
  const std::string id = here_.make(first_mesh()).filed.record.id;
  here_.settle();
  const auto expect_elsewhere = [&](const ErrorInfo& why) {
    EXPECT_EQ(why.reason, "DESIGN_ELSEWHERE");
    EXPECT_EQ(why.home, home);
  };
  expect_elsewhere(there_.fail(first_mesh()));
  expect_elsewhere(there_.fail(edit_of("plate", 81)));
  EditCommand named = std::get<EditCommand>(edit_of(id, 81));
  named.design = "plate";
  expect_elsewhere(there_.fail(named));
  expect_elsewhere(error_of([&] { there_.session->set_head("plate@1", "", ""); }));
  expect_elsewhere(error_of([&] { there_.session->set_head(id, "plate", ""); }));
  expect_elsewhere(error_of([&] { there_.session->remove_design("plate", ""); }));
  expect_elsewhere(error_of([&] { there_.session->list({.design = "plate"}, {}); }));
  EXPECT_EQ(there_.engine.made(), 0) << "it is refused before anything is computed";
  here_.make(edit_of("plate", 81));
}

TEST_F(HomesTest, WhatNamesNoDesignIsFiledWhereItsHomeIs) {
  CreateCommand unnamed = std::get<CreateCommand>(first_mesh());
  unnamed.design.clear();
  unnamed.source.name = "plate";
  const Made away = there_.make(unnamed);
  EXPECT_EQ(away.filed.place.design, "");
  EXPECT_EQ(there_.make(edit_of(away.filed.record.id, 81)).filed.place.design, "");
  const Made at_home = here_.make(unnamed);
  EXPECT_EQ(at_home.filed.record.id, away.filed.record.id);
  EXPECT_EQ(at_home.filed.place.design, "plate");
  EXPECT_EQ(here_.make(edit_of(at_home.filed.record.id, 82)).filed.place.design, "plate");
  unnamed.head.file = true;
  EXPECT_EQ(there_.fail(unnamed).reason, "DESIGN_ELSEWHERE");
}

}  // namespace
}  // namespace remeshd::test
