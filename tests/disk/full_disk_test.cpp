#include "tests/disk/full_disk.h"

#include <atomic>
#include <mutex>
#include <vector>

#include "server/session/shared_designs.h"
#include "tests/server/designs/design_shelf.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

TEST_F(FullDisk, RevisionsAreMadeListedAndServedThatAreNotDurable) {
  EXPECT_TRUE(file(1).durable);
  EXPECT_TRUE(store_->healthy());
  fill_disk();
  const Filed filed = file(2);
  EXPECT_FALSE(filed.durable);
  EXPECT_EQ(filed.place.number, 2U);
  EXPECT_FALSE(store_->healthy());
  EXPECT_EQ(listing(*store_), "plate@1 = 1 head\nplate@2 = 2\n");
  EXPECT_NE(archive_->get(id(2), kRun), nullptr);
  EXPECT_FALSE(file(2).durable) << "asked for again";
  EXPECT_TRUE(file(1).durable) << "it was stored before";
  calls_.decide({});
}

TEST_F(FullDisk, IsWarnedOfInTheAnswerThatIsNotDurable) {
  const auto warned = [](const Filed& filed) {
    return std::ranges::count(filed.warnings, WarningCode::NotDurable, &Warning::code) == 1;
  };
  EXPECT_FALSE(warned(file(1)));
  fill_disk();
  EXPECT_TRUE(warned(file(2)));
  EXPECT_TRUE(warned(file(2))) << "asked for again";
  EXPECT_FALSE(warned(file(1))) << "it was stored before";
  EXPECT_TRUE(warned(archive_->file(made(1), "another", {}))) << "its place is in memory alone";
  make_room();
  EXPECT_FALSE(warned(file(2)));
}

TEST_F(FullDisk, FilesNothingWhereTheRequestWantsItDurable) {
  file(1);
  for (const char* full : {"packs/", "journal"}) {
    calls_.decide([full](const FileCall& call, std::size_t) {
      const bool grows = call.kind == FileCall::Kind::Write || call.kind == FileCall::Kind::Create;
      return grows && call.path.find(full) != std::string::npos ? ENOSPC : 0;
    });
    const ErrorInfo error =
        error_of([&] { archive_->file(made(2), "plate", {}, {WarningCode::NotDurable}); });
    EXPECT_EQ(error.reason, "WARNING_IS_ERROR");
    EXPECT_EQ(listing(*store_), "plate@1 = 1 head\n") << full;
  }
  fill_disk();
  file(2);
  EXPECT_EQ(
      error_of([&] { archive_->file(made(2), "plate", {}, {WarningCode::NotDurable}); }).reason,
      "WARNING_IS_ERROR")
      << "asked for again";
  make_room();
  EXPECT_TRUE(archive_->file(made(2), "plate", {}, {WarningCode::NotDurable}).durable);
}

TEST_F(FullDisk, IsRecoveredFromByItself) {
  file(1);
  fill_disk();
  file(2);
  make_room();
  EXPECT_TRUE(store_->healthy());
  EXPECT_TRUE(file(2).durable);
  open();
  EXPECT_EQ(listing(*store_), "plate@1 = 1 head\nplate@2 = 2\n");
  EXPECT_NE(archive_->find(id(2), kRun), nullptr) << "its mesh is stored";
}

TEST_F(FullDisk, IsRecoveredFromByItselfWhereNothingIsToBeSaved) {
  file(1);
  file(2);
  for (const int error : {ENOSPC, EIO}) {
    std::atomic<int> tries = 0;
    calls_.decide([&, error](const FileCall& call, std::size_t) {
      const bool grows = call.kind == FileCall::Kind::Write || call.kind == FileCall::Kind::Create;
      tries += grows;
      return grows ? error : 0;
    });
    const std::string head = error == EIO ? id(1) : id(2);
    EXPECT_ANY_THROW(archive_->set_head(head, "plate", ""));
    EXPECT_TRUE(eventually([&] { return tries > 3; })) << "nobody sees whether it works again";
    EXPECT_FALSE(store_->healthy());
    calls_.decide({});
    EXPECT_TRUE(eventually([&] { return store_->healthy(); }));
    EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
    archive_->set_head(head, "plate", "");
  }
}

TEST_F(FullDisk, KeepsTheStoreUnhealthyUntilThereIsRoomForWhatWaits) {
  file(1);
  std::mutex mutex;
  std::vector<bool> heard;
  store_->on_health([&](bool healthy) {
    const std::scoped_lock lock(mutex);
    heard.push_back(healthy);
  });
  std::atomic<int> tries = 0;
  calls_.decide([&](const FileCall& call, std::size_t) {
    const bool for_a_pack =
        call.kind == FileCall::Kind::Create && call.path.find("packs/") != std::string::npos;
    tries += for_a_pack;
    return for_a_pack ? ENOSPC : 0;
  });
  EXPECT_FALSE(file(2).durable);
  archive_->set_head(id(1), "plate", "");  // takes a line of the journal, for which there is room
  EXPECT_TRUE(eventually([&] { return tries > 3; })) << "nobody sees whether it works again";
  make_room();
  EXPECT_TRUE(archive_->is_durable(id(2)));
  store_->on_health({});
  EXPECT_EQ(heard, (std::vector<bool>{true, false, true}));
}

TEST_F(FullDisk, AHeadThatTheFarmHasMovedHasMoved) {
  file(1);
  file(2);
  archive_.reset();
  SharedParts farm;
  farm.designs = std::make_unique<SharedDesigns>(std::make_shared<DesignShelf>(), "", *store_);
  archive_.emplace(engine_, *store_, memory_, nullptr, nullptr, std::move(farm));
  const std::string before = archive_->resolve("plate").id;
  const std::string other = before == id(1) ? id(2) : id(1);
  fill_disk();
  EXPECT_EQ(archive_->set_head(other, "plate", "").design.head, other);
  EXPECT_EQ(archive_->resolve("plate").id, other);
  EXPECT_FALSE(store_->healthy());
  make_room();
  open();
  EXPECT_EQ(archive_->resolve("plate").id, other) << "stored once there is room";
}

TEST_F(FullDisk, WhatWasNotDurableIsNotThereAfterACrash) {
  file(1);
  fill_disk();
  file(2);
  const FileRecord record = calls_.record();
  const fs::path after = folder_ / "after";
  write_after_power_cut(
      record, record.calls.size(), [] { return true; }, after);
  Store store(after);
  EXPECT_EQ(listing(store), "plate@1 = 1 head\n");
  calls_.decide({});
}

}  // namespace
}  // namespace remeshd::test
