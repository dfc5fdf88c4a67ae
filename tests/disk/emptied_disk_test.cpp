#include "tests/disk/full_disk.h"

// A full disk from which revisions and meshes are deleted, so that it has room again.
namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class EmptiedDisk : public FullDisk {
 protected:
  EmptiedDisk() {
    file(1);
    file(2);
  }
  [[nodiscard]] bool stored(int n) const {
    return fs::exists(folder_ / "packs" / id(n).substr(0, 2) / id(n).substr(2));
  }
};

TEST_F(EmptiedDisk, LetsARevisionBeDeletedForGood) {
  fill_disk_until_a_pack_goes();
  EXPECT_TRUE(archive_->remove("plate@1", true).mesh_deleted);
  EXPECT_FALSE(stored(1));
  EXPECT_TRUE(store_->healthy());
  open();
  EXPECT_EQ(listing(*store_), "plate@2 = 2 head\n");
}

TEST_F(EmptiedDisk, LetsADesignBeDeletedForGood) {
  fill_disk_until_a_pack_goes();
  EXPECT_EQ(archive_->remove_design("plate", "").meshes_deleted, 2U);
  open();
  EXPECT_EQ(listing(*store_), "");
  EXPECT_FALSE(stored(1) || stored(2));
}

TEST_F(EmptiedDisk, LetsMeshesGoThatAreMadeAgainWhenAskedFor) {
  fill_disk_until_a_pack_goes();
  EXPECT_EQ(archive_->collect_garbage({.disk_bytes = 0}).meshes, 2U);
  EXPECT_FALSE(stored(1) || stored(2));
  open();
  EXPECT_EQ(archive_->cache_stats().stored, 0U);
  EXPECT_NE(archive_->get(id(1), kRun), nullptr);
}

TEST_F(EmptiedDisk, LetsMeshesGoOfWhichAnotherIsToldByTheFirst) {
  archive_->file(made(3, id(2)), "plate", {});
  ASSERT_EQ(store_->read([](Catalogue& c) { return c.revision(id(3))->base; }), id(2));
  archive_->remove("plate@1", true);
  fill_disk_until_a_pack_goes();
  EXPECT_EQ(archive_->collect_garbage({.disk_bytes = 0}).meshes, 2U);
  EXPECT_FALSE(stored(2) || stored(3));
}

TEST_F(EmptiedDisk, StoresWhatWaitedForRoom) {
  fill_disk_until_a_pack_goes();
  EXPECT_FALSE(file(3).durable);
  archive_->remove("plate@1", true);
  EXPECT_TRUE(eventually([&] { return archive_->is_durable(id(3)) && store_->healthy(); }));
  open();
  EXPECT_EQ(listing(*store_), "plate@2 = 2\nplate@3 = 3 head\n");
}

TEST_F(EmptiedDisk, TakesADeletionThatGivesNoRoomOnceItHasSome) {
  fill_disk();
  archive_->remove("plate@1", true);
  EXPECT_EQ(listing(*store_), "plate@2 = 2 head\n");
  EXPECT_FALSE(store_->healthy());
  make_room();
  open();
  EXPECT_EQ(listing(*store_), "plate@2 = 2 head\n");
}

TEST_F(EmptiedDisk, LosesNothingElseWhereverPowerIsCut) {
  fill_disk_until_a_pack_goes();
  const std::size_t before = calls_.record().calls.size();
  archive_->remove("plate@1", true);
  const FileRecord record = calls_.record();
  ASSERT_GT(record.calls.size(), before + 2);
  archive_.reset();
  for (std::size_t count = before; count <= record.calls.size(); ++count)
    for (const bool keep : {false, true}) {
      const fs::path after = folder_ / "after";
      write_after_power_cut(
          record, count, [keep] { return keep; }, after);
      {
        Store store(after);
        Archive archive(engine_, store, memory_);
        EXPECT_TRUE(!has(store, 1) || archive.get(id(1), kRun)) << "it has its recipe";
        EXPECT_NE(archive.find(id(2), kRun), nullptr);
      }
      fs::remove_all(after);
    }
}

}  // namespace
}  // namespace remeshd::test
