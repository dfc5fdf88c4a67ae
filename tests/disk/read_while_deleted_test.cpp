#include "tests/disk/full_disk.h"

// Meshes that are read at the moment when garbage is collected.
namespace remeshd::test {
namespace {

class ReadWhileDeleted : public FullDisk {
 protected:
  ReadWhileDeleted() {
    file(1);
    archive_->file(made(2, id(1)), "plate", {});
    EXPECT_EQ(store_->read([](Catalogue& c) { return c.revision(id(2))->base; }), id(1));
    open();  // with nothing in memory
  }
  static std::string pack(int n) { return "packs/" + id(n).substr(0, 2) + "/" + id(n).substr(2); }
  void collect_when_opened(int n) {
    calls_.before_opening(
        pack(n), [this] { EXPECT_EQ(archive_->collect_garbage({.disk_bytes = 0}).meshes, 1U); });
  }
};

TEST_F(ReadWhileDeleted, AMeshIsReadThoughTheOneThatItStoodOnGoes) {
  archive_->set_pin("plate@2", true);
  collect_when_opened(1);
  EXPECT_NE(archive_->find(id(2), kRun), nullptr);
  EXPECT_EQ(archive_->cache_stats().stored, 1U);
}

TEST_F(ReadWhileDeleted, AMeshIsSoundThoughTheOneThatItStoodOnGoesAsItIsChecked) {
  archive_->set_pin("plate@2", true);
  collect_when_opened(1);
  EXPECT_FALSE(archive_->check_stored(id(2)));
}

TEST_F(ReadWhileDeleted, AMeshThatGoesIsNotThere) {
  archive_->set_pin("plate@1", true);
  collect_when_opened(2);
  EXPECT_EQ(archive_->find(id(2), kRun), nullptr);
}

}  // namespace
}  // namespace remeshd::test
