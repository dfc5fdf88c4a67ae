#include "server/store/first_layout.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "proto/checksum.h"
#include "server/store/checked_line.h"
#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Stores as versions before there was a FORMAT wrote them.
class FirstLayoutTest : public StoreFolderTest {
 protected:
  fs::path path_of_object(const std::string& hash) const {
    return folder_ / "objects" / hash.substr(0, 2) / hash.substr(2);
  }
  /// Writes an object; returns its hash.
  std::string write_object(int n, unsigned number, const std::string& parent = "") const {
    const json head = {{"format", "remeshd-revision-1"},
                       {"id", id(n)},
                       {"parent", parent},
                       {"model_name", record(n).model_name},
                       {"created_ns", record(n).created_ns},
                       {"nodes", 7},
                       {"tets", 8},
                       {"design", "d"},
                       {"number", number}};
    const std::string bytes = head.dump() + "\n" + bytes_of(n);
    const std::string hash = sha256_hex(bytes);
    write(path_of_object(hash), bytes);
    return hash;
  }
  static std::string journal_line(const std::vector<json>& operations) {
    return checked_line(json(operations).dump());
  }
  std::string line_of(int n, unsigned number, const std::string& hash,
                      const std::string& parent = "") const {
    return journal_line({{{"add_revision", id(n)},
                          {"parent", parent},
                          {"model_name", record(n).model_name},
                          {"object", hash},
                          {"created_ns", record(n).created_ns},
                          {"nodes", 7},
                          {"tets", 8},
                          {"bytes", 100}},
                         {{"add_place", "d"}, {"number", number}, {"id", id(n)}},
                         {{"set_head", "d"}, {"id", id(n)}}});
  }
  /// Revisions 1 and 2, the second a child of the first.
  void write_two() {
    const std::string one = write_object(1, 1), two = write_object(2, 2, id(1));
    write(folder_ / "journal", line_of(1, 1, one) + line_of(2, 2, two, id(1)));
    write(folder_ / "index.sqlite", "SQLite format 3, say");
    fs::create_directories(folder_ / "objects" / "tmp");
  }
  void expect_both(Store& store) const {
    EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\n");
    EXPECT_EQ(read(store, 1), bytes_of(1));
    EXPECT_EQ(read(store, 2), bytes_of(2));
    EXPECT_EQ(store.read([](Catalogue& c) { return c.revision(id(2))->parent; }), id(1));
  }
};

TEST_F(FirstLayoutTest, IsMigrated) {
  write_two();
  {
    Store store(folder_);
    expect_both(store);
  }
  EXPECT_TRUE(fs::exists(folder_ / "FORMAT"));
  for (const char* gone : {"objects", "journal", "index.sqlite"})
    EXPECT_FALSE(fs::exists(folder_ / gone)) << gone;
  Store again(folder_);
  expect_both(again);
  EXPECT_TRUE(again.notes().empty());
}

TEST_F(FirstLayoutTest, WithoutItsJournalIsMigratedFromItsObjects) {
  for (const char* journal : {"missing", "empty"}) {
    fs::remove_all(folder_);
    write_two();
    fs::remove(folder_ / "journal");
    if (journal == std::string("empty")) write(folder_ / "journal", "");
    Store store(folder_);
    expect_both(store);
  }
}

TEST_F(FirstLayoutTest, ALineThatChangedInTheJournalLosesNothing) {
  write_two();
  const std::string text = content(folder_ / "journal");
  for (std::size_t byte = 0; byte < text.size(); byte += 7) {
    fs::remove_all(folder_);
    write_two();
    flip_bit(folder_ / "journal", byte, byte % 8);
    Store store(folder_);
    expect_both(store);
  }
}

TEST_F(FirstLayoutTest, AMigrationThatWasInterruptedGoesOn) {
  write_two();
  { const Store store(folder_); }
  // The journal of today was not written yet, one object not brought in, FORMAT was.
  for (const auto& entry : fs::directory_iterator(folder_ / "quarantine"))
    if (entry.path().filename().string().ends_with("-journal"))
      fs::rename(entry.path(), folder_ / "journal");
  ASSERT_TRUE(fs::exists(folder_ / "journal"));
  fs::remove(folder_ / "journal.a");
  fs::remove(folder_ / "journal.b");
  fs::remove(folder_ / "packs" / id(2).substr(0, 2) / id(2).substr(2));
  write_object(2, 2, id(1));
  Store store(folder_);
  expect_both(store);
}

TEST_F(FirstLayoutTest, APackThatAnInterruptedMigrationLeftHalfWrittenIsNoCopy) {
  write_two();
  { const Store store(folder_); }
  const fs::path pack = folder_ / "packs" / id(2).substr(0, 2) / id(2).substr(2);
  write(pack, content(pack).substr(0, fs::file_size(pack) - 3));
  write_object(2, 2, id(1));
  Store store(folder_);
  expect_both(store);
}

TEST_F(FirstLayoutTest, RevisionsThatWereDeletedStayDeleted) {
  write_two();
  std::ofstream(folder_ / "journal", std::ios::app)
      << journal_line({{{"remove_place", "d"}, {"number", 1}}, {{"remove_revision", id(1)}}});
  {
    Store store(folder_);  // its object was not deleted yet
    EXPECT_EQ(listing(store), "d@2 = 2 head\n");
  }
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@2 = 2 head\n");
}

TEST_F(FirstLayoutTest, ADamagedObjectGoesToTheQuarantine) {
  write_two();
  const std::string hash = write_object(2, 2, id(1));
  flip_bit(path_of_object(hash), 300);
  const std::string damaged = content(path_of_object(hash));
  Store store(folder_);
  EXPECT_EQ(read(store, 1), bytes_of(1));
  bool kept = false;
  for (const auto& [name, bytes] : files())
    kept |= name.starts_with("quarantine/") && bytes == damaged;
  EXPECT_TRUE(kept);
  EXPECT_THAT(store.notes(), testing::Contains(testing::HasSubstr("it is damaged")));
}

TEST_F(FirstLayoutTest, AStoreInWhichNothingWasStoredIsKnownByItsIndex) {
  const std::string table =
      "CREATE TABLE meta(key TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID";
  for (const char* with_table : {"index.sqlite", "index.sqlite-wal"}) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "objects" / "tmp");
    write(folder_ / "journal", "");
    write(folder_ / "lock", "");
    for (const char* name : {"index.sqlite", "index.sqlite-wal", "index.sqlite-shm"})
      write(folder_ / name, "bytes of SQLite" + (name == std::string(with_table) ? table : ""));
    { const Store store(folder_); }
    EXPECT_FALSE(fs::exists(folder_ / "objects"));
    EXPECT_FALSE(fs::exists(folder_ / "index.sqlite"));
    EXPECT_TRUE(fs::exists(folder_ / "FORMAT"));
  }
}

TEST_F(FirstLayoutTest, WhatAnOlderProgramLeftInAStoreOfTodayIsTakenIn) {
  {
    Store store(folder_);
    file(store, 1);
  }
  const std::string two = write_object(2, 2, id(1));
  write(folder_ / "journal", line_of(2, 2, two, id(1)));
  Store store(folder_);
  expect_both(store);
}

}  // namespace
}  // namespace remeshd::test
