#include "server/store/store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "engine/base/error.h"
#include "proto/checksum.h"

namespace remeshd {
namespace {

namespace fs = std::filesystem;

class StoreTest : public testing::Test {
 protected:
  StoreTest()
      : folder_(fs::temp_directory_path() / ("remeshd-store-test-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~StoreTest() override { fs::remove_all(folder_); }

  static RevisionRecord record(const std::string& id) {
    return {.id = id,
            .parent = "",
            .model_name = "m\n\"\xC3\xA4",
            .object = "o",
            .created_ns = 5,
            .nodes = 7,
            .tets = 8,
            .bytes = 9};
  }

  const fs::path folder_;
};

TEST_F(StoreTest, ObjectsAreNamedByTheirHashAndReadBack) {
  Objects objects(folder_);
  const std::string bytes("abc\0def", 7);
  const std::string hash = objects.put(bytes);
  EXPECT_EQ(hash, sha256_hex(bytes));
  EXPECT_EQ(objects.get(hash), bytes);
  EXPECT_EQ(objects.put(bytes), hash);
  EXPECT_EQ(objects.list(), std::vector<std::string>{hash});
  objects.remove(hash);
  objects.remove(hash);
  EXPECT_TRUE(objects.list().empty());
  EXPECT_THROW(static_cast<void>(objects.get(hash)), Error);
}

TEST_F(StoreTest, ADamagedObjectIsNoticedAndWrittenAnew) {
  Objects objects(folder_);
  const std::string hash = objects.put("abc");
  std::ofstream(objects.path_of(hash)) << "abd";
  EXPECT_THROW(static_cast<void>(objects.get(hash)), Error);
  objects.put("abc");
  EXPECT_EQ(objects.get(hash), "abc");
}

TEST_F(StoreTest, WhatACrashLeftHalfWrittenIsCleared) {
  { Objects objects(folder_); }
  std::ofstream(folder_ / "tmp" / "123-0") << "half";
  Objects objects(folder_);
  EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
  EXPECT_TRUE(objects.list().empty());
}

TEST_F(StoreTest, TheJournalGivesItsTransactionsBack) {
  {
    Journal journal(folder_ / "journal");
    journal.append({AddRevision{record("aa")}, AddPlace{"d", 1, "aa"}, SetHead{"d", "aa"}});
    journal.append({RemovePlace{"d", 1}, RemoveRevision{"aa"}});
  }
  const Journal journal(folder_ / "journal");
  std::vector<Transaction> seen;
  EXPECT_EQ(journal.replay(0, [&](const Transaction& t) { seen.push_back(t); }), 0U);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(std::get<AddRevision>(seen[0][0]).record, record("aa"));
  EXPECT_EQ(std::get<AddPlace>(seen[0][1]).number, 1U);
  EXPECT_EQ(std::get<SetHead>(seen[0][2]).id, "aa");
  EXPECT_EQ(std::get<RemovePlace>(seen[1][0]).design, "d");
  EXPECT_EQ(std::get<RemoveRevision>(seen[1][1]).id, "aa");
}

TEST_F(StoreTest, ATornLastLineIsCutOffAndADamagedOneLeftOut) {
  const fs::path file = folder_ / "journal";
  {
    Journal journal(file);
    for (const char* id : {"aa", "bb", "cc"}) journal.append({RemoveRevision{id}});
  }
  const auto whole = fs::file_size(file);
  std::ofstream(file, std::ios::app) << "0123abcd [{\"remove_rev";
  {
    std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
    f.seekp(static_cast<std::int64_t>(whole / 2));  // in the second line
    f.put('~');
  }
  Journal journal(file);
  EXPECT_EQ(journal.size(), whole);
  EXPECT_EQ(fs::file_size(file), whole);
  std::vector<std::string> ids;
  const auto bad = journal.replay(
      0, [&](const Transaction& t) { ids.push_back(std::get<RemoveRevision>(t[0]).id); });
  EXPECT_EQ(bad, 1U);
  EXPECT_EQ(ids, (std::vector<std::string>{"aa", "cc"}));
}

TEST_F(StoreTest, ATransactionHappensAsAWholeOrNotAtAll) {
  Catalogue catalogue(":memory:");
  catalogue.apply({AddRevision{record("aa")}, AddPlace{"d", 1, "aa"}, SetHead{"d", "aa"}}, 10, 3);
  // The number is taken: the revision before it must not stay.
  EXPECT_THROW(catalogue.apply({AddRevision{record("bb")}, AddPlace{"d", 1, "bb"}}, 20, 4), Error);
  EXPECT_FALSE(catalogue.revision("bb"));
  EXPECT_EQ(catalogue.journal_size(), 10U);
  EXPECT_EQ(catalogue.journal_mark(), 3U);
  EXPECT_EQ(catalogue.revision("aa"), record("aa"));
}

TEST_F(StoreTest, NextNumbersOnlyGrow) {
  Catalogue catalogue(":memory:");
  catalogue.apply({AddPlace{"d", 5, "aa"}, AddPlace{"d", 2, "bb"}}, 1, 1);
  EXPECT_EQ(catalogue.design("d")->next_number, 6U);
  catalogue.apply({RemovePlace{"d", 5}, RemovePlace{"d", 2}}, 2, 2);
  EXPECT_EQ(catalogue.design("d")->next_number, 6U);
  EXPECT_EQ(catalogue.design("d")->revisions, 0U);
}

TEST_F(StoreTest, PrefixesFindEveryIdThatBeginsWithThem) {
  Catalogue catalogue(":memory:");
  for (const char* id : {"abc0", "abcf", "abd0", "ab"})
    catalogue.apply({AddRevision{record(id)}}, 1, 1);
  EXPECT_EQ(catalogue.with_prefix("abc", 9), (std::vector<std::string>{"abc0", "abcf"}));
  EXPECT_EQ(catalogue.with_prefix("abcf", 9), std::vector<std::string>{"abcf"});
  EXPECT_TRUE(catalogue.with_prefix("ac", 9).empty());
}

TEST_F(StoreTest, AFullDiskIsAnErrorThatSaysSo) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  File full("/dev/full", 1 /* O_WRONLY */);
  try {
    full.write("x");
    FAIL() << "/dev/full took a byte";
  } catch (const Error& error) {
    EXPECT_EQ(error.info().reason, "StoreFull");
    EXPECT_EQ(error.info().kind, ErrorKind::ResourceExhausted);
  }
}

}  // namespace
}  // namespace remeshd
