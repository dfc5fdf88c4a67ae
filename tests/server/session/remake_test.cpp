#include <gmock/gmock.h>
#include <pthread.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <memory>

#include "server/limits.h"
#include "server/session/verification.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A chain of edits of a plate in a store: `plate@1`, `plate@2`, ...
class RemakeTest : public testing::Test {
 protected:
  RemakeTest() {
    open();
    create(100);
    for (int dx = 81; dx <= 83; ++dx) edit("plate", dx);
    for (int n = 1; n <= 4; ++n) {
      ids_.push_back(session_->resolve(name(n)).id);
      recipes_.push_back(write_recipe(session_->recipe(ids_.back())));
    }
  }

  static std::string name(int n) { return "plate@" + std::to_string(n); }
  void open(std::uint64_t disk = 0) {
    session_.reset();  // which has the store
    session_ = only_session(engine_, folder_.open(), {.disk = disk});
  }
  ErrorInfo create(std::uint32_t nodes) {
    Answer answer;
    ModelSource source = model_of({block("plate", 80, 40, 10)});
    source.sizes = {{"fine", "plate.top", 2.0}};
    source.groups = {{"load", "plate.top"}};
    session_->make(
        CreateCommand{.source = std::move(source), .options = {.nodes = nodes}, .design = "plate"},
        answer.listener());
    EXPECT_TRUE(answer.came());
    return answer.error();
  }
  Made edit(const std::string& base, double dx) {
    Answer answer;
    session_->make(EditCommand{.base = base,
                               .edit = {{SetFeatureParameter{"plate", "dx", Scalar(dx)}}},
                               .document = "{}"},
                   answer.listener());
    return answer.made();
  }
  /// The recipe of what is served: it has the digests of every array.
  std::string served(int n) {
    const HeldRevisionPtr held = session_->get(ids_[static_cast<std::size_t>(n - 1)], kRun);
    HeldRevision known;
    known.record = held->record;
    known.revision = held->revision;
    known.edit = held->edit;
    known.asked = session_->recipe(held->record.id).options;
    return write_recipe(recipe_of(known));
  }
  fs::path pack(int n) const {
    const std::string& id = ids_[static_cast<std::size_t>(n - 1)];
    return folder_.path() / "packs" / id.substr(0, 2) / id.substr(2);
  }
  std::uint64_t bytes_of_packs() const {
    std::uint64_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "packs"))
      if (entry.is_regular_file()) bytes += entry.file_size();
    return bytes;
  }
  void damage(int n) const { fs::resize_file(pack(n), fs::file_size(pack(n)) - 1); }
  void expect_all_served() {
    for (int n = 1; n <= 4; ++n)
      EXPECT_EQ(served(n), recipes_[static_cast<std::size_t>(n - 1)]) << n;
  }

  FakeEngine fake_;
  Engine engine_ = fake_.engine();
  StoreFolder folder_;
  std::shared_ptr<Session> session_;
  std::vector<std::string> ids_, recipes_;
};

TEST_F(RemakeTest, DamagedMeshesAreMadeAgainAndStored) {
  for (int n = 1; n <= 4; ++n) {
    session_.reset();
    damage(n);
    open();
    expect_all_served();
    EXPECT_GT(session_->cache().cache_stats().remade, 0U);
    open();
    expect_all_served();
    EXPECT_EQ(session_->cache().cache_stats().remade, 0U) << "it was stored again";
  }
}

TEST_F(RemakeTest, AllOfAChainMayBeGone) {
  session_.reset();
  for (int n = 1; n <= 4; ++n) fs::remove(pack(n));
  open();
  EXPECT_EQ(served(4), recipes_[3]);
  EXPECT_EQ(session_->cache().cache_stats().remade, 4U);
  expect_all_served();
}

/// Calls `what` on a thread that has a stack of so many bytes.
void call_on_stack(std::size_t bytes, const std::function<void()>& what) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, bytes), 0);
  pthread_t thread{};
  const auto start = [](void* call) -> void* {
    (*static_cast<const std::function<void()>*>(call))();
    return nullptr;
  };
  std::function<void()> call = what;
  ASSERT_EQ(pthread_create(&thread, &attributes, start, &call), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

TEST_F(RemakeTest, AChainMayBeLongerThanTheStackIsDeep) {
  constexpr int kEdits = 1000;
  constexpr std::size_t kStack = std::size_t{512} << 10U;
  for (int n = 1; n <= kEdits; ++n) edit("plate", 100 + 0.01 * n);
  const std::string last = session_->resolve("plate").id;
  session_.reset();
  fs::remove_all(folder_.path() / "packs");
  open();
  call_on_stack(kStack, [&] { EXPECT_EQ(session_->get(last, kRun)->record.id, last); });
  EXPECT_EQ(session_->cache().cache_stats().remade, 4U + kEdits);
}

TEST_F(RemakeTest, WhatIsMadeAgainTakesItsMemoryFromTheBudget) {
  session_.reset();
  damage(4);
  std::uint64_t leased = 0;
  engine_.make_revision = [this, &leased, make = engine_.make_revision](
                              const Revision* original, const ModelSource& source,
                              const MeshOptions& options, const remeshd::Run& run) {
    const Load load = session_->load();
    leased = load.memory_bytes - load.held_bytes;
    return make(original, source, options, run);
  };
  open();
  EXPECT_EQ(served(4), recipes_[3]);
  EXPECT_GE(leased, 100 * limits::kBytesPerNode);
}

TEST_F(RemakeTest, TheParentMayHaveBeenDeleted) {
  session_->remove("plate@2", true);
  session_.reset();
  damage(3);
  open();
  EXPECT_EQ(served(3), recipes_[2]);
  EXPECT_EQ(error_of([&] { session_->get(ids_[1], kRun); }).reason, "REVISION_NOT_FOUND");
}

TEST_F(RemakeTest, TheRecipeIsReadOutOfThePackWhereTheJournalIsLost) {
  session_.reset();
  damage(4);
  for (const char* journal : {"journal.a", "journal.b"}) fs::remove(folder_.path() / journal);
  open();
  EXPECT_EQ(served(4), recipes_[3]);
}

TEST_F(RemakeTest, AnIntactMeshOfAnOlderAlgorithmIsServedAndEditedAndALostOneIsOutdated) {
  session_.reset();
  damage(4);
  engine_.algorithm_version += 1;
  open();
  EXPECT_EQ(served(3), recipes_[2]);
  EXPECT_EQ(edit(ids_[2], 90).filed.place.number, 5U);
  const ErrorInfo error = error_of([&] { session_->get(ids_[3], kRun); });
  EXPECT_EQ(error.reason, "REVISION_OUTDATED");
  EXPECT_EQ(error.kind, ErrorKind::FailedPrecondition);
  EXPECT_THAT(error.hint, HasSubstr("remesh remake " + ids_[3].substr(0, 12)));
}

TEST_F(RemakeTest, AnotherMeshIsNeverServedUnderTheOldId) {
  session_.reset();
  damage(1);
  engine_.make_revision = [make = engine_.make_revision](
                              const Revision* original, const ModelSource& source,
                              const MeshOptions& options, const remeshd::Run& run) {
    Revision revision = make(original, source, options, run);
    revision.output.mesh.nodes.edit(3).x += 1e-16;
    return revision;
  };
  open();
  for (int attempt = 0; attempt < 2; ++attempt) {
    const ErrorInfo error = error_of([&] { session_->get(ids_[0], kRun); });
    EXPECT_EQ(error.reason, "NOT_REPRODUCIBLE");
    EXPECT_EQ(error.kind, ErrorKind::DataLoss);
    EXPECT_EQ(create(100).reason, "NOT_REPRODUCIBLE") << "by the request that made it";
  }
  EXPECT_EQ(session_->load().held, 0U);
}

TEST_F(RemakeTest, MeshesGoToABudgetAndComeBack) {
  const std::uint64_t all = session_->load().disk_bytes;
  const Collected tried = session_->cache().collect_garbage({.disk_bytes = 0, .dry_run = true});
  EXPECT_EQ(tried.meshes, 4U);
  EXPECT_EQ(session_->load().disk_bytes, all);
  const Collected collected = session_->cache().collect_garbage({.disk_bytes = all / 2});
  EXPECT_LE(collected.disk_bytes, all / 2);
  EXPECT_EQ(collected.disk_bytes, session_->load().disk_bytes);
  EXPECT_EQ(collected.bytes_freed, all - collected.disk_bytes);
  EXPECT_EQ(session_->cache().cache_stats().evictions, collected.meshes);
  open();
  EXPECT_EQ(bytes_of_packs(), collected.disk_bytes);
  expect_all_served();
}

TEST_F(RemakeTest, PacksOfDeletedRevisionsThatOthersStandOnCountAndGo) {
  for (int n = 1; n <= 3; ++n) session_->remove(name(n), false);
  open();
  const std::uint64_t all = session_->load().disk_bytes;
  EXPECT_EQ(all, bytes_of_packs());
  EXPECT_EQ(session_->cache().cache_stats().disk_bytes, all);
  EXPECT_TRUE(fs::exists(pack(1)));
  const Collected collected = session_->cache().collect_garbage({.disk_bytes = all - 1});
  EXPECT_EQ(collected.meshes, 0U);
  EXPECT_LT(collected.disk_bytes, all);
  EXPECT_EQ(collected.disk_bytes, bytes_of_packs());
  for (int n = 1; n <= 3; ++n) EXPECT_FALSE(fs::exists(pack(n))) << n;
  open();
  EXPECT_EQ(served(4), recipes_[3]);
  EXPECT_EQ(session_->cache().cache_stats().remade, 0U);
}

TEST_F(RemakeTest, ABudgetIsKeptAllAlong) {
  const std::uint64_t one = fs::file_size(pack(1));
  open(3 * one);
  for (int dx = 84; dx < 94; ++dx) edit("plate", dx);
  session_.reset();  // which waits for what is under way
  open(3 * one);
  EXPECT_LE(session_->cache().collect_garbage({}).disk_bytes, 3 * one);
  expect_all_served();
}

TEST_F(RemakeTest, APinnedMeshStays) {
  EXPECT_TRUE(session_->cache().set_pin("plate@2", true).record.pinned);
  open();
  session_->cache().collect_garbage({.disk_bytes = 0});
  std::map<std::string, CacheEntry> entries;
  for (const CacheEntry& entry : session_->cache().cache_entries())
    entries[entry.record.id] = entry;
  EXPECT_EQ(entries[ids_[0]].state, MeshState::Recipe);
  EXPECT_EQ(entries[ids_[1]].state, MeshState::Stored);
  EXPECT_EQ(entries[ids_[3]].depth, 2);
  EXPECT_FALSE(session_->cache().set_pin("plate@2", false).record.pinned);
  EXPECT_EQ(session_->cache().collect_garbage({.disk_bytes = 0}).meshes, 1U);
}

TEST_F(RemakeTest, WhatIsDamagedIsFoundAndRepaired) {
  const auto faults = [&](bool repair) {
    std::vector<CacheFault> found;
    for (CacheVerification all(session_->cache()); !all.ended();) {
      const auto fault = all.next();
      if (!fault) continue;
      if (!repair) {
        found.push_back(*fault);
        continue;
      }
      std::promise<CacheFault> told;
      session_->repair(*fault, {}, [&](const CacheFault& result) { told.set_value(result); });
      found.push_back(told.get_future().get());
    }
    return found;
  };
  EXPECT_TRUE(faults(false).empty());
  damage(2);
  const auto found = faults(false);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].revision, ids_[1]);
  EXPECT_FALSE(found[0].repaired);
  for (const CacheFault& fault : faults(true)) EXPECT_TRUE(fault.repaired);
  EXPECT_TRUE(faults(false).empty());
}

}  // namespace
}  // namespace remeshd::test
