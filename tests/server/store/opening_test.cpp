#include "server/store/opening.h"

#include <gmock/gmock.h>

#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

/// Of what earlier processes left in a store.
class Opening : public StoreFolderTest {
 protected:
  fs::path pack(int n) const { return folder_ / "packs" / id(n).substr(0, 2) / id(n).substr(2); }
  void make(int revisions) {
    Store store(folder_);
    for (int n = 1; n <= revisions; ++n) file(store, n);
  }
  bool quarantined(const std::string& bytes) {
    for (const auto& [name, found] : files())
      if (name.starts_with("quarantine/") && found == bytes) return true;
    return false;
  }
  /// Three revisions, of which an intact journal does not have the last.
  void make_three_and_forget_one() {
    make(2);
    const std::string before = content(folder_ / "journal.a");
    Store store(folder_);
    file(store, 3);
    for (const char* name : {"journal.a", "journal.b"}) write(folder_ / name, before);
  }
  /// As a pack that is not written yet.
  void mark_pack(int n) const { fs::permissions(pack(n), fs::perms::owner_read); }
};

TEST_F(Opening, WhatNoStoreWasWritingGoesToTheQuarantine) {
  make(1);
  for (const char* name : {"letter.txt", "123", "1-2-3-4", "01-2", "1-", "a-1", "more/1-2"})
    write(folder_ / "tmp" / name, name);
  fs::create_symlink("/dev/null", folder_ / "tmp" / "5-6");
  write(folder_ / "tmp" / "123-4567-0", "half a pack");
  Store store(folder_);
  file(store, 2);
  EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
  for (const char* name : {"letter.txt", "123", "1-2-3-4", "01-2", "1-", "a-1", "more/1-2"})
    EXPECT_TRUE(quarantined(name)) << name;
  EXPECT_TRUE(fs::is_symlink(folder_ / "quarantine" / "tmp-5-6"));
  EXPECT_FALSE(quarantined("half a pack"));
}

TEST_F(Opening, ADamagedPackThatAnOlderJournalDoesNotNameGoesToTheQuarantine) {
  make_three_and_forget_one();
  std::string whole = content(pack(3)), flipped = whole;
  flipped[whole.size() - 9] ^= 1;
  for (const std::string& damaged : {flipped, whole.substr(0, whole.size() - 9)}) {
    write(pack(3), damaged);
    Store store(folder_);
    EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\n");
    EXPECT_FALSE(fs::exists(pack(3)));
    EXPECT_TRUE(quarantined(damaged));
    EXPECT_THAT(store.notes(), testing::Contains(testing::HasSubstr("does not name it")));
  }
}

TEST_F(Opening, APackOfAWriteThatWasCutOffIsDeletedByTheFirstCommit) {
  make_three_and_forget_one();
  const std::string whole = content(pack(3));
  for (const std::size_t size : {std::size_t{0}, std::size_t{9}, whole.size() - 9}) {
    write(pack(3), whole.substr(0, size));
    mark_pack(3);
    Store store(folder_);
    EXPECT_TRUE(store.notes().empty());
    EXPECT_EQ(content(pack(3)).size(), size) << "opening deletes nothing";
    store.commit([](Catalogue&) { return Transaction{SetHead{"d", id(1)}}; });
    EXPECT_FALSE(fs::exists(pack(3)));
    EXPECT_FALSE(fs::exists(folder_ / "quarantine"));
  }
}

TEST_F(Opening, APackThatWasWrittenWholeBeforeACrashIsTakenIn) {
  make_three_and_forget_one();
  mark_pack(3);
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2\nd@3 = 3 head\n");
  EXPECT_FALSE(is_being_written(pack(3)));
}

TEST_F(Opening, APackThatWasReplacedAgainstAnotherBaseBeforeACrashKeepsThatBase) {
  {
    Store store(folder_);
    for (const int n : {1, 2, 3}) file(store, n);  // each against the one before
    RevisionRecord moved = record(3, id(2));
    const StoredArrays of_base = arrays_of(bytes_of(1));
    const Packs::Base base{id(1), &of_base};
    store.put(moved, {.design = "d", .number = 3, .id = id(3)}, "", arrays_of(bytes_of(3)), &base);
    ASSERT_EQ(moved.base, id(1));  // and is not entered any more
  }
  Store store(folder_);
  EXPECT_EQ(store.read([](Catalogue& c) { return c.revision(id(3)); })->base, id(1));
  remove(store, 2);
  remove(store, 1);
  EXPECT_EQ(read(store, 3), bytes_of(3));
}

}  // namespace
}  // namespace remeshd::test
