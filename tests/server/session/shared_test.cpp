#include <gmock/gmock.h>

#include <atomic>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "server/session/stored_form.h"
#include "server/tier/sealed_object.h"
#include "tests/server/session/farm.h"

namespace remeshd::test {
namespace {

using SharedTest = FarmTest;

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

TEST_F(SharedTest, NoRecipeComesBeforeThoseThatItIsMadeOf) {
  open(here_);
  shelf_->fails = true;
  std::map<std::string, std::string> parents;
  std::string last = here_.make(first_mesh()).filed.record.id;
  for (int dx = 100; dx < 130; ++dx) {
    const std::string id = here_.make(edit_of(last, dx)).filed.record.id;
    parents[id] = std::exchange(last, id);
  }
  std::atomic<int> orphans = 0;
  shelf_->before_put = [&](const std::string& key) {
    if (!key.starts_with("recipe/")) return;
    const auto parent = parents.find(key.substr(key.rfind('/') + 1));
    if (parent != parents.end() &&
        shelf_->keys("recipe/" + parent->second.substr(0, 2) + "/" + parent->second).empty())
      ++orphans;
  };
  shelf_->fails = false;
  here_.settle();
  EXPECT_EQ(orphans, 0);
  EXPECT_EQ(shelf_->keys("recipe/").size(), 31U);
}

TEST_F(SharedTest, TakesWhatIsThereInPlaceOfComputing) {
  open(here_);
  const auto ids = make_chain(here_);
  here_.settle();
  open(there_);
  there_.engine.close_gate();
  const Made made = there_.make(first_mesh());
  EXPECT_EQ(made.filed.record.id, ids[0]);
  EXPECT_TRUE(made.cached);
  EXPECT_TRUE(there_.engine.wait_stopped(1));
  there_.engine.open_gate();
}

TEST_F(SharedTest, DoesNotWaitForADownloadOnceItIsComputed) {
  open(here_);
  const auto ids = make_chain(here_);
  here_.settle();
  open(there_);
  shelf_->get_hangs = true;
  const Made made = there_.make(first_mesh());
  EXPECT_EQ(made.filed.record.id, ids[0]);
  EXPECT_FALSE(made.cached);
  shelf_->get_hangs = false;
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
  const std::string object = *shelf_->get(packs[0], {});
  shelf_->put(packs[0], *shelf_->get(packs[1], {}));
  expect_right();
  EXPECT_EQ(quarantined(), 1U);
  EXPECT_EQ(there_.engine.made(), 1);
  EXPECT_EQ(unsealed(packs[0], *shelf_->get(packs[0], {}), kFarmKey).size() > 0, true)
      << "it was written over";
}

TEST_F(WrongObjectTest, AnotherFarmsObjectsAreNotUsed) {
  for (const std::string& key : shelf_->keys("pack/"))
    shelf_->put(key, sealed(key, unsealed(key, *shelf_->get(key, {}), kFarmKey), "another farm's"));
  expect_right();
  EXPECT_EQ(there_.engine.made(), 4);
}

TEST_F(WrongObjectTest, WhatIsSealedRightAndIsWrongIsNotUsed) {
  const auto packs = shelf_->keys("pack/");
  const auto recipes = shelf_->keys("recipe/");
  // A pack of another revision, and no pack at all.
  shelf_->put(packs[0],
              sealed(packs[0], unsealed(packs[1], *shelf_->get(packs[1], {}), kFarmKey), kFarmKey));
  shelf_->put(packs[2], sealed(packs[2], "no pack", kFarmKey));
  expect_right();
  EXPECT_GE(quarantined(), 2U);
}

TEST_F(WrongObjectTest, AnotherRevisionsRecipeIsNotUsed) {
  const auto recipes = shelf_->keys("recipe/");
  for (const std::string& key : shelf_->keys("pack/")) shelf_->remove(key);
  const std::string other = unsealed(recipes[1], *shelf_->get(recipes[1], {}), kFarmKey);
  shelf_->put(recipes[0], sealed(recipes[0], other, kFarmKey));
  open(there_);
  const std::string id = recipes[0].substr(recipes[0].rfind('/') + 1);
  EXPECT_EQ(there_.fail(edit_of(id, 90)).reason, "REVISION_NOT_FOUND");
  EXPECT_EQ(quarantined(), 1U);
}

/// A daemon of the farm whose engine or memory is faulty.
class FaultyReplicaTest : public WrongObjectTest {
 protected:
  FaultyReplicaTest() {
    faulty_.engine.go_wrong();
    faulty_.session = only_session(faulty_.engine.engine(), faulty_.folder.open());
    EXPECT_EQ(make_chain(faulty_), ids_);
  }
  void put_pack(const std::string& id, const std::string& pack) {
    for (const std::string& key : shelf_->keys("pack/"))
      if (key.find(id) != std::string::npos) shelf_->put(key, sealed(key, pack, kFarmKey));
  }
  /// Writes a pack of the arrays of one daemon with the recipe of another.
  static std::string mixed(Store& scratch, const Replica& arrays_of, const Replica& recipe_of,
                           const std::string& id, const Packs::Base* base = nullptr) {
    const HeldRevisionPtr held = arrays_of.session->get(id, kRun);
    RevisionRecord record = held->record;
    scratch.put(record, {.id = id}, recipe_of.session->cache().store().recipe(id),
                stored_form(arrays_of.engine.engine(), *held), base);
    return scratch.pack(id);
  }

  Replica faulty_;
  const StoreFolder scratch_folder_;
};

TEST_F(FaultyReplicaTest, ItsMeshesAreNotUsed) {
  for (const std::string& id : ids_) put_pack(id, faulty_.session->cache().store().pack(id));
  expect_right();
  EXPECT_EQ(there_.engine.made(), 4);
}

TEST_F(FaultyReplicaTest, AMeshThatIsNotItsRecipesIsServedNeither) {
  Store scratch(scratch_folder_.path());
  put_pack(ids_[0], mixed(scratch, faulty_, here_, ids_[0]));
  open(there_);
  EXPECT_EQ(there_.served(ids_[0]), right_[0]);
  EXPECT_EQ(there_.served(ids_[0]), right_[0]);
  there_.settle();
  expect_right();
  EXPECT_EQ(there_.engine.made(), 1) << "the pack was written over";
}

TEST_F(FaultyReplicaTest, NorIsABaseThatIsNotItsRecipes) {
  Store scratch(scratch_folder_.path());
  const std::string pack = mixed(scratch, faulty_, here_, ids_[0]);
  const HeldRevisionPtr wrong = faulty_.session->get(ids_[0], kRun);
  const StoredArrays arrays = stored_form(faulty_.engine.engine(), *wrong);
  const Packs::Base base{ids_[0], &arrays};
  const std::string on_it = mixed(scratch, here_, here_, ids_[1], &base);
  ASSERT_EQ(Packs::head_in(on_it)->record.base, ids_[0]);
  put_pack(ids_[0], pack);
  put_pack(ids_[1], on_it);
  for (int process = 0; process < 2; ++process) {
    open(there_);
    EXPECT_EQ(there_.served(ids_[1]), right_[1]) << process;
  }
  open(there_);
  EXPECT_EQ(there_.served(ids_[0]), right_[0]) << "its store has the wrong one";
  expect_right();
}

TEST_F(WrongObjectTest, BitsThatChangeAreNeverServed) {
  const auto keys = shelf_->keys();
  for (int i = 0; i < 40; ++i) {
    const std::string& key = keys[static_cast<std::size_t>(i) % keys.size()];
    const std::string object = *shelf_->get(key, {});
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
