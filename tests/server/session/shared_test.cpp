#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "server/tier/sealed_object.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/server/tier/shelf.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd::test {
namespace {

const std::string kFarmKey = "the key of this farm";

/// Revisions in a tier that daemons share, each with a store of its own.
class SharedTest : public testing::Test {
 protected:
  /// A daemon of the farm.
  struct Replica {
    FakeEngine engine;
    StoreFolder folder;
    std::shared_ptr<Session> session;

    Made make(Command command) const {
      Answer answer;
      session->make(std::move(command), answer.listener());
      return answer.made();
    }
    ErrorInfo fail(Command command) const {
      Answer answer;
      session->make(std::move(command), answer.listener());
      return answer.error();
    }
    /// Everything that is served of a revision: its recipe has the digests of every array.
    [[nodiscard]] std::string served(const std::string& id) const {
      const HeldRevisionPtr held = session->get(id, kRun);
      HeldRevision known;
      known.record = held->record;
      known.revision = held->revision;
      known.edit = held->edit;
      known.asked = session->recipe(id).options;
      return write_recipe(recipe_of(known));
    }
    /// Waits until the tier has all that it is to have.
    void settle() const {
      for (int i = 0; i < 1000 && session->cache().tier_waiting() > 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      EXPECT_EQ(session->cache().tier_waiting(), 0U);
    }
  };

  [[nodiscard]] Sharing sharing(bool acknowledge_in_tier = false) {
    return {.objects = shelf_,
            .farm_key = kFarmKey,
            .acknowledge_in_tier = acknowledge_in_tier,
            .tell = {}};
  }
  void open(Replica& replica, bool acknowledge_in_tier = false) {
    replica.session.reset();  // which has the store
    replica.session = only_session(replica.engine.engine(), replica.folder.open(), {},
                                   sharing(acknowledge_in_tier));
  }
  static Command first() {
    return CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                         .options = {.nodes = 100},
                         .design = "plate"};
  }
  static Command edit_of(const std::string& base, double dx) {
    return EditCommand{
        .base = base, .edit = {{SetFeatureParameter{"plate", "dx", Scalar(dx)}}}, .document = "{}"};
  }
  /// A first mesh and three edits of it, one of the other.
  std::vector<std::string> make_chain(const Replica& replica) {
    std::vector<std::string> ids{replica.make(first()).filed.record.id};
    for (int dx = 81; dx <= 83; ++dx)
      ids.push_back(replica.make(edit_of(ids.back(), dx)).filed.record.id);
    return ids;
  }

  std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  Replica here_, there_;
};

TEST_F(SharedTest, AnotherDaemonContinuesALoop) {
  open(here_);
  open(there_);
  const auto ids = make_chain(here_);
  here_.settle();
  const Made made = there_.make(edit_of(ids.back(), 84));
  EXPECT_EQ(there_.engine.made(), 1) << "the base came from the tier";
  EXPECT_EQ(made.filed.record.id, here_.make(edit_of(ids.back(), 84)).filed.record.id);
  for (const std::string& id : ids) EXPECT_EQ(there_.served(id), here_.served(id));
  EXPECT_EQ(there_.engine.made(), 1);
}

TEST_F(SharedTest, ItsMeshesOutliveAllStores) {
  open(here_);
  const auto ids = make_chain(here_);
  here_.settle();
  const std::string served = here_.served(ids[3]);
  here_.session.reset();
  open(there_);
  EXPECT_EQ(there_.served(ids[3]), served);
  EXPECT_EQ(there_.engine.made(), 0);
  there_.session.reset();
  open(there_);
  shelf_->fails = true;
  EXPECT_EQ(there_.served(ids[3]), served) << "its store has it from then on";
}

TEST_F(SharedTest, RecipesAloneMakeAMeshAgain) {
  open(here_);
  const auto ids = make_chain(here_);
  here_.settle();
  for (const std::string& key : shelf_->keys("pack/")) shelf_->remove(key);
  open(there_);
  EXPECT_EQ(there_.served(ids[3]), here_.served(ids[3]));
  EXPECT_EQ(there_.engine.made(), 4);
  there_.settle();
  EXPECT_THAT(shelf_->keys("pack/"), testing::Contains(testing::HasSubstr(ids[3])));
}

TEST_F(SharedTest, AFailureIsNoMiss) {
  open(here_);
  const auto ids = make_chain(here_);
  here_.settle();
  open(there_);
  shelf_->fails = true;
  const ErrorInfo why = there_.fail(edit_of(ids[1], 84));
  EXPECT_EQ(why.reason, "TIER_UNAVAILABLE");
  EXPECT_EQ(why.kind, ErrorKind::Unavailable);
  EXPECT_GT(why.retry_after.value_or(0), 0);
  EXPECT_EQ(here_.fail(edit_of(ids[1], 84)).reason, "") << "who has the base needs no tier";
  shelf_->fails = false;
  there_.make(edit_of(ids[1], 84));
  EXPECT_EQ(there_.fail(edit_of(std::string(64, '0'), 84)).reason, "REVISION_NOT_FOUND");
}

TEST_F(SharedTest, AnEditIsAcknowledgedInTheTier) {
  open(here_, true);
  const auto ids = make_chain(here_);
  for (const std::string& id : ids)
    EXPECT_THAT(shelf_->keys("recipe/"), testing::Contains(testing::HasSubstr(id)));
  shelf_->fails = true;
  const ErrorInfo why = here_.fail(edit_of(ids[3], 84));
  EXPECT_EQ(why.reason, "TIER_UNAVAILABLE");
  EXPECT_EQ(here_.fail(edit_of(ids[3], 84)).reason, "TIER_UNAVAILABLE") << "though it is made";
  shelf_->fails = false;
  const std::string id = here_.make(edit_of(ids[3], 84)).filed.record.id;
  EXPECT_THAT(shelf_->keys("recipe/"), testing::Contains(testing::HasSubstr(id)));
  EXPECT_EQ(here_.engine.made(), 5);
}

TEST_F(SharedTest, WhatWaitsOutlivesTheProcess) {
  open(here_);
  shelf_->fails = true;
  const auto ids = make_chain(here_);
  EXPECT_EQ(here_.session->cache().tier_waiting(), 8U);
  open(here_);
  EXPECT_EQ(here_.session->cache().tier_waiting(), 8U);
  shelf_->fails = false;
  here_.settle();
  EXPECT_EQ(shelf_->keys().size(), 8U);
}

TEST_F(SharedTest, AStoreFromBeforeIsSharedAsItIsUsed) {
  here_.session = only_session(here_.engine.engine(), here_.folder.open());
  const auto ids = make_chain(here_);
  open(here_, true);
  EXPECT_TRUE(shelf_->keys().empty());
  here_.make(edit_of(ids[2], 84));
  here_.settle();
  EXPECT_EQ(shelf_->keys("recipe/").size(), 4U) << "the edit and what it is made of";
}

TEST_F(SharedTest, WhatIsAcknowledgedDoesNotWantForItsAncestors) {
  here_.session = only_session(here_.engine.engine(), here_.folder.open());
  const auto ids = make_chain(here_);
  open(here_, true);
  shelf_->fails = true;
  EXPECT_EQ(here_.fail(edit_of(ids[3], 84)).reason, "TIER_UNAVAILABLE");
  shelf_->fails = false;
  here_.make(edit_of(ids[3], 84));
  EXPECT_EQ(shelf_->keys("recipe/").size(), 5U);
}

TEST_F(SharedTest, TakesWhatIsThereInPlaceOfComputing) {
  open(here_);
  const auto ids = make_chain(here_);
  here_.settle();
  open(there_);
  there_.engine.close_gate();
  const Made made = there_.make(first());
  EXPECT_EQ(made.filed.record.id, ids[0]);
  EXPECT_TRUE(made.cached);
  EXPECT_TRUE(there_.engine.wait_stopped(1));
  there_.engine.open_gate();
}

/// Objects that are not what a daemon of the farm wrote under their key.
class WrongObjectTest : public SharedTest {
 protected:
  WrongObjectTest() {
    open(here_);
    ids_ = make_chain(here_);
    here_.settle();
    for (const std::string& id : ids_) right_.push_back(here_.served(id));
  }
  /// Another daemon serves what it should, whatever the tier has.
  void expect_right() {
    open(there_);
    for (std::size_t i = 0; i < ids_.size(); ++i) EXPECT_EQ(there_.served(ids_[i]), right_[i]) << i;
    there_.settle();
  }
  [[nodiscard]] std::size_t quarantined() const {
    return there_.session->cache().store().room().quarantined;
  }

  std::vector<std::string> ids_, right_;
};

TEST_F(WrongObjectTest, AMeshUnderAnothersKeyIsNotUsed) {
  const auto packs = shelf_->keys("pack/");
  const std::string object = *shelf_->get(packs[0]);
  shelf_->put(packs[0], *shelf_->get(packs[1]));
  expect_right();
  EXPECT_EQ(quarantined(), 1U);
  EXPECT_EQ(there_.engine.made(), 1);
  EXPECT_EQ(unsealed(packs[0], *shelf_->get(packs[0]), kFarmKey).size() > 0, true)
      << "it was written over";
}

TEST_F(WrongObjectTest, AnotherFarmsObjectsAreNotUsed) {
  for (const std::string& key : shelf_->keys("pack/"))
    shelf_->put(key, sealed(key, unsealed(key, *shelf_->get(key), kFarmKey), "another farm's"));
  expect_right();
  EXPECT_EQ(there_.engine.made(), 4);
}

TEST_F(WrongObjectTest, WhatIsSealedRightAndIsWrongIsNotUsed) {
  const auto packs = shelf_->keys("pack/");
  const auto recipes = shelf_->keys("recipe/");
  // A pack of another revision, and no pack at all.
  shelf_->put(packs[0],
              sealed(packs[0], unsealed(packs[1], *shelf_->get(packs[1]), kFarmKey), kFarmKey));
  shelf_->put(packs[2], sealed(packs[2], "no pack", kFarmKey));
  expect_right();
  EXPECT_GE(quarantined(), 2U);
}

TEST_F(WrongObjectTest, AnotherRevisionsRecipeIsNotUsed) {
  const auto recipes = shelf_->keys("recipe/");
  for (const std::string& key : shelf_->keys("pack/")) shelf_->remove(key);
  const std::string other = unsealed(recipes[1], *shelf_->get(recipes[1]), kFarmKey);
  shelf_->put(recipes[0], sealed(recipes[0], other, kFarmKey));
  open(there_);
  const std::string id = recipes[0].substr(recipes[0].rfind('/') + 1);
  EXPECT_EQ(there_.fail(edit_of(id, 90)).reason, "REVISION_NOT_FOUND");
  EXPECT_EQ(quarantined(), 1U);
}

TEST_F(WrongObjectTest, BitsThatChangeAreNeverServed) {
  const auto keys = shelf_->keys();
  for (int i = 0; i < 40; ++i) {
    const std::string& key = keys[static_cast<std::size_t>(i) % keys.size()];
    const std::string object = *shelf_->get(key);
    std::string changed = object;
    const std::size_t bit = static_cast<std::size_t>(i) * 7919 % (8 * object.size());
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    shelf_->put(key, changed);
    Replica fresh;
    open(fresh);
    const bool of_recipe = key.find("recipe/") != std::string::npos;
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      if (of_recipe && key.find(ids_[k]) != std::string::npos) continue;  // it is unknown then
      EXPECT_EQ(fresh.served(ids_[k]), right_[k]) << key << ", bit " << bit;
    }
    fresh.settle();
    fresh.session.reset();
    shelf_->put(key, object);
  }
}

}  // namespace
}  // namespace remeshd::test
