#include <gtest/gtest.h>

#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>

#include "server/session/archive.h"
#include "tests/disk/file_calls.h"
#include "tests/server/fake_engine.h"
#include "tests/server/store/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;

/// A disk on which one sync, of the pack or of the journal, takes until it is let go.
class SlowDisk : public StoreFolderTest, public testing::WithParamInterface<const char*> {
 protected:
  HeldRevisionPtr made(int n) {
    auto held = std::make_shared<HeldRevision>();
    held->asked = MeshOptions{.nodes = 100};
    held->revision = engine_.make_revision(nullptr, model_of({block("plate", 80 + n, 40, 10)}),
                                           *held->asked, kRun);
    held->record = {.id = id(n), .algorithm_version = engine_.algorithm_version, .created_ns = n};
    return held;
  }
  void hang() {
    calls_.before_syncing([this](const std::string& path) {
      if (!path.starts_with(GetParam())) return;
      std::unique_lock lock(mutex_);
      hanging_ = !released_;
      changed_.notify_all();
      changed_.wait(lock, [&] { return released_; });
    });
  }
  bool hangs() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 10s, [&] { return hanging_; });
  }
  void let_go() {
    const std::scoped_lock lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }

  FakeEngine fake_;
  const Engine engine_ = fake_.engine();
  std::mutex mutex_;
  std::condition_variable changed_;
  bool hanging_ = false, released_ = false;
  FileCalls calls_{folder_};
  Store store_{folder_};
  MemoryBudget memory_{1 << 30};
  Archive archive_{engine_, store_, memory_};
};

TEST_P(SlowDisk, HoldsUpNeitherTheCatalogueNorAnswersFromMemory) {
  const HeldRevisionPtr first = made(1);
  archive_.file(first, "plate", {});
  const HeldRevisionPtr second = made(2);
  hang();
  std::jthread filing([&] { archive_.file(second, "plate", {}); });
  ASSERT_TRUE(hangs());
  auto others = std::async(std::launch::async, [&] {
    return archive_.file(first, "plate", {}).place.number == 1 &&
           archive_.resolve("plate@1").id == id(1) && archive_.get(id(1), kRun) == first &&
           archive_.cache_entries().size() == 1 && listing(store_) == "plate@1 = 1 head\n";
  });
  const bool in_time = others.wait_for(10s) == std::future_status::ready;
  let_go();
  EXPECT_TRUE(in_time);
  EXPECT_TRUE(others.get());
}

INSTANTIATE_TEST_SUITE_P(, SlowDisk, testing::Values("packs/", "journal.a"), [](const auto& test) {
  return std::string(test.param) == "packs/" ? "Pack" : "Journal";
});

}  // namespace
}  // namespace remeshd::test
