#include "server/session/archive.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/fake_engine.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd::test {
namespace {

class ArchiveTest : public testing::Test {
 protected:
  /// A revision as a computation ends with it.
  HeldRevisionPtr computed(const std::string& id = std::string(64, 'a')) {
    auto held = std::make_shared<HeldRevision>();
    held->revision = engine_.make_revision(nullptr, model_of({block("plate", 80, 40, 10)}),
                                           MeshOptions{.nodes = 100}, kRun);
    held->record.id = id;
    return held;
  }

  FakeEngine fake_;
  const Engine engine_ = fake_.engine();
  Store store_;
  MemoryBudget memory_{1 << 30};
  Archive archive_{engine_, store_, memory_};
  const HeldRevisionPtr revision_ = computed();
  const std::string& id_ = revision_->record.id;
};

TEST_F(ArchiveTest, WhatIsFiledStaysInMemoryAndWhatIsNotGoes) {
  archive_.hold(revision_);
  archive_.drop_unfiled(id_);
  EXPECT_EQ(archive_.held().count(), 0U);

  archive_.hold(revision_);
  archive_.file(revision_, "plate", {});
  archive_.drop_unfiled(id_);
  EXPECT_EQ(archive_.get(id_, kRun), revision_);
}

TEST_F(ArchiveTest, ARevisionThatWasDroppedBeforeItIsFiledIsThereOnceItIs) {
  archive_.hold(revision_);
  const HeldRevisionPtr found = archive_.find(id_, kRun);  // by another request for it
  archive_.drop_unfiled(id_);                              // the one that computed it has left
  archive_.file(found, "plate", {});
  EXPECT_EQ(archive_.get(archive_.resolve("plate").id, kRun), revision_);
}

TEST_F(ArchiveTest, ARevisionThatWasDeletedBeforeItIsFiledAgainIsThereOnceItIs) {
  archive_.hold(revision_);
  archive_.file(revision_, "plate", {});
  const HeldRevisionPtr found = archive_.find(id_, kRun);
  archive_.remove("plate@1", true);
  EXPECT_EQ(archive_.held().count(), 0U);
  EXPECT_EQ(archive_.file(found, "plate", {}).place.number, 2U);
  EXPECT_EQ(archive_.get(archive_.resolve("plate").id, kRun), revision_);
}

TEST_F(ArchiveTest, ARevisionThatIsFiledAgainWhileItsDesignIsDeletedStaysInMemory) {
  const auto is_known = [&] {
    return store_.read([&](Catalogue& catalogue) { return catalogue.revision(id_).has_value(); });
  };
  std::vector<HeldRevisionPtr> others;  // before it in the design: removed from memory before it
  for (int i = 1000; i < 1100; ++i)
    others.push_back(computed(std::to_string(i) + std::string(60, 'b')));
  for (int round = 0; round < 20; ++round) {
    for (const auto& other : others) archive_.file(other, "plate", {});
    archive_.file(revision_, "plate", {});
    std::thread again([&] {
      while (is_known()) std::this_thread::yield();
      archive_.file(revision_, "another", {});
    });
    archive_.remove_design("plate", "");
    again.join();
    EXPECT_TRUE(archive_.held().contains(id_)) << "in round " << round;
    archive_.remove_design("another", "");
  }
}

TEST_F(ArchiveTest, WhatIsFiledTwiceCountsOnceInMemory) {
  archive_.file(revision_, "plate", {});
  const std::uint64_t bytes = archive_.held().bytes();
  archive_.file(revision_, "another", {});
  EXPECT_EQ(archive_.held().count(), 1U);
  EXPECT_EQ(archive_.held().bytes(), bytes);
}

TEST_F(ArchiveTest, WithoutAStoreThereIsRoomWhileLessIsHeldThanMayBe) {
  archive_.file(revision_, "plate", {});
  const std::uint64_t bytes = archive_.held().bytes();
  const auto check = [&](std::uint64_t most) {
    Store store;
    MemoryBudget memory(1 << 30, most);
    Archive archive(engine_, store, memory);
    archive.file(revision_, "plate", {});
    EXPECT_EQ(memory.held(), bytes);
    archive.check_room(1);
  };
  EXPECT_EQ(error_of([&] { check(bytes); }).reason, "MEMORY_FULL");
  EXPECT_NO_THROW(check(bytes + 1));
}

TEST_F(ArchiveTest, WhoeverFilesNextWritesADamagedCopyAgain) {
  const StoreFolder folder;
  {
    const auto store = folder.open();
    Archive(engine_, *store, memory_).file(revision_, "plate", {});
  }
  folder.damage_objects();
  const auto store = folder.open();
  MemoryBudget memory(1 << 30), memory_of_reader(1 << 30);
  Archive archive(engine_, *store, memory);
  EXPECT_EQ(error_of([&] { archive.find(id_, kRun); }).reason, "STORE_CORRUPTED");
  archive.file(revision_, "another", {});
  Archive reader(engine_, *store, memory_of_reader);
  EXPECT_EQ(reader.get(id_, kRun)->revision.output.mesh.nodes.size(), 100U);
}

}  // namespace
}  // namespace remeshd::test
