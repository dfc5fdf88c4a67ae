#include "server/store/store.h"

#include <gmock/gmock.h>

#include "engine/base/error.h"
#include "server/store/checked_line.h"
#include "server/store/journal_line.h"
#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class StoreTest : public StoreFolderTest {
 protected:
  fs::path pack(int n) const { return folder_ / "packs" / id(n).substr(0, 2) / id(n).substr(2); }
  void make(int revisions) {
    Store store(folder_);
    for (int n = 1; n <= revisions; ++n) file(store, n);
  }
  std::uint64_t bytes_of_packs() {
    std::uint64_t bytes = 0;
    for (const auto& [name, found] : files())
      if (name.starts_with("packs/")) bytes += found.size();
    return bytes;
  }
  void damage_both_journals(const std::function<std::string(std::string)>& damage) {
    for (const char* name : {"journal.a", "journal.b"})
      write(folder_ / name, damage(content(folder_ / name)));
  }
  bool quarantined(const std::string& bytes) {
    for (const auto& [name, found] : files())
      if (name.starts_with("quarantine/") && found == bytes) return true;
    return false;
  }
  static std::string without_line(const std::string& text, int line) {
    std::size_t start = 0;
    for (int i = 0; i < line; ++i) start = text.find('\n', start) + 1;
    return text.substr(0, start) + text.substr(text.find('\n', start) + 1);
  }
};

constexpr const char* kThree = "d@1 = 1\nd@2 = 2\nd@3 = 3 head\n";

TEST_F(StoreTest, WhatWasCommittedIsThereAfterAnotherOpening) {
  make(3);
  Store store(folder_);
  EXPECT_TRUE(store.notes().empty());
  EXPECT_EQ(listing(store), kThree);
  for (int n = 1; n <= 3; ++n) EXPECT_EQ(read(store, n), bytes_of(n));
}

TEST_F(StoreTest, OpeningAWholeStoreChangesNoFile) {
  make(3);
  const auto before = files();
  { const Store store(folder_); }
  EXPECT_EQ(files(), before);
}

TEST_F(StoreTest, OpeningDeletesNothing) {
  make(3);
  {
    Store store(folder_);
    remove(store, 3);
  }
  // What a crash may leave, and what others may have put there.
  write(folder_ / "tmp" / "123-0", "half a pack");
  write(pack(3), "the pack of a revision that was deleted");
  write(folder_ / "packs" / "README", "a note");
  write(folder_ / "packs" / "zz" / "file", "a file");
  write(folder_ / "README", "a note of the administrator");
  write(pack(9), "no pack");
  std::ofstream(folder_ / "journal.a", std::ios::app) << "no line";
  std::multiset<std::string> before;
  for (const auto& [name, bytes] : files())
    if (!name.starts_with("journal")) before.insert(bytes);
  { const Store store(folder_); }
  std::multiset<std::string> after;
  for (const auto& [name, bytes] : files())
    if (!name.starts_with("journal")) after.insert(bytes);
  after.erase("no line\n");
  EXPECT_EQ(after, before);
  EXPECT_TRUE(quarantined("no pack"));
  EXPECT_TRUE(quarantined("a note"));
  EXPECT_TRUE(quarantined("no line\n"));
  EXPECT_EQ(content(folder_ / "README"), "a note of the administrator");
}

TEST_F(StoreTest, TheFirstCommitDeletesWhatACrashLeft) {
  make(3);
  {
    Store store(folder_);
    remove(store, 3);
  }
  write(folder_ / "tmp" / "123-0", "half a pack");
  write(pack(3), "the pack of a revision that was deleted");
  Store store(folder_);
  file(store, 4);
  EXPECT_FALSE(fs::exists(pack(3)));
  EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2\nd@4 = 4 head\n");
}

TEST_F(StoreTest, ADeletedRevisionStaysDeletedThoughItsPackAndARewrittenJournalAreThere) {
  make(2);
  const std::string bytes = content(pack(2));
  {
    Store store(folder_);
    remove(store, 2);
  }
  write(pack(2), bytes);
  fs::remove(folder_ / "journal.b");  // so that the next opening rewrites both
  { const Store store(folder_); }
  Store store(folder_);
  EXPECT_FALSE(has(store, 2));
}

TEST_F(StoreTest, ADeletedRevisionMayBeStoredAgain) {
  make(2);
  Store store(folder_);
  remove(store, 2);
  EXPECT_FALSE(fs::exists(pack(2)));
  file(store, 2);
  EXPECT_EQ(read(store, 2), bytes_of(2));
  EXPECT_EQ(listing(store), "d@1 = 1\nd@3 = 2 head\n");
}

TEST_F(StoreTest, APackStaysForAsLongAsAnotherStandsOnIt) {
  make(3);
  {
    Store store(folder_);
    remove(store, 1);
    remove(store, 2);
    EXPECT_TRUE(fs::exists(pack(1)));
    EXPECT_TRUE(fs::exists(pack(2)));
    EXPECT_EQ(read(store, 3), bytes_of(3));
    EXPECT_EQ(store.bytes(), bytes_of_packs());
    EXPECT_EQ(store.base_of(id(2)), id(1));
    EXPECT_THAT(store.on_removed_bases(), ElementsAre(Pair(id(3), id(2))));
  }
  {
    Store store(folder_);  // knows them for what they are
    EXPECT_EQ(store.bytes(), bytes_of_packs());
    EXPECT_EQ(store.base_of(id(2)), id(1));
    EXPECT_EQ(listing(store), "d@3 = 3 head\n");
    EXPECT_TRUE(store.notes().empty());
    file(store, 4, "e");
    EXPECT_EQ(read(store, 3), bytes_of(3));
    remove(store, 3);
  }
  for (int n = 1; n <= 3; ++n) EXPECT_FALSE(fs::exists(pack(n))) << n;
}

TEST_F(StoreTest, APackThatWasReplacedKeepsItsNewBaseThoughTheCommitFailed) {
  make(3);
  Store store(folder_);
  RevisionRecord third = record(3, id(2));
  const StoredArrays first = arrays_of(bytes_of(1));
  const Packs::Base base{id(1), &first};
  store.put(third, {.design = "d", .number = 3, .id = id(3)}, "", arrays_of(bytes_of(3)), &base);
  ASSERT_EQ(third.base, id(1));
  EXPECT_ANY_THROW(store.commit([&](Catalogue&) {
    return Transaction{AddRevision{third}, AddPlace{"d", 1, id(3)}};  // which another one has
  }));
  remove(store, 2);
  remove(store, 1);
  EXPECT_EQ(read(store, 3), bytes_of(3));
  EXPECT_FALSE(fs::exists(pack(2)));
}

TEST_F(StoreTest, APackThatACrashCutOffWasNeverAcknowledgedAndGoesWithTheFirstCommit) {
  make(2);
  {
    Store store(folder_);
    RevisionRecord third = record(3, id(2));
    store.put(third, {.design = "d", .number = 3, .id = id(3)}, "", arrays_of(bytes_of(3)));
  }
  write(pack(3), content(pack(3)).substr(0, fs::file_size(pack(3)) - 3));
  fs::permissions(pack(3), fs::perms::owner_read);  // as long as not all of it is written
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\n");
  EXPECT_TRUE(store.notes().empty());
  EXPECT_TRUE(fs::exists(pack(3)));
  file(store, 4);
  EXPECT_FALSE(fs::exists(pack(3)));
}

TEST_F(StoreTest, WhatWasPutAndIsNotCommittedStaysUntilItIsGivenUp) {
  Store store(folder_);
  file(store, 1);
  RevisionRecord second = record(2, id(1));
  const StoredArrays of_base = arrays_of(bytes_of(1));
  const Packs::Base base{id(1), &of_base};
  store.put(second, {.design = "d", .number = 2, .id = id(2)}, "", arrays_of(bytes_of(2)), &base);
  ASSERT_EQ(second.base, id(1));
  remove(store, 1);  // which another one is about to stand on
  EXPECT_TRUE(fs::exists(pack(1)));
  EXPECT_TRUE(fs::exists(pack(2)));
  store.discard(id(2));
  file(store, 3, "e");
  EXPECT_FALSE(fs::exists(pack(1)));
  EXPECT_FALSE(fs::exists(pack(2)));
}

TEST_F(StoreTest, WithoutItsJournalTheStoreIsMadeAgainFromThePacks) {
  for (const char* journal : {"missing", "empty"}) {
    fs::remove_all(folder_);
    make(3);
    for (const char* name : {"journal.a", "journal.b"}) {
      if (journal == std::string("empty")) {
        write(folder_ / name, "");
      } else {
        fs::remove(folder_ / name);
      }
    }
    {
      Store store(folder_);
      EXPECT_EQ(listing(store), kThree) << journal;
      EXPECT_EQ(read(store, 2), bytes_of(2));
      EXPECT_THAT(store.notes(), Contains(HasSubstr("3 revisions")));
    }
    Store again(folder_);
    EXPECT_EQ(listing(again), kThree);
    EXPECT_TRUE(again.notes().empty());
  }
}

TEST_F(StoreTest, ALineLostInBothJournalsIsReadOutOfThePack) {
  for (int line = 1; line <= 3; ++line) {  // line 0 starts anew
    fs::remove_all(folder_);
    make(3);
    damage_both_journals([&](const std::string& text) { return without_line(text, line); });
    Store store(folder_);
    EXPECT_EQ(listing(store), kThree) << "without line " << line;
    for (int n = 1; n <= 3; ++n) EXPECT_EQ(read(store, n), bytes_of(n));
  }
}

TEST_F(StoreTest, AJournalOfBeforeThatWasPutBackLosesNoRevision) {
  make(1);
  const std::string first = content(folder_ / "journal.a");
  {
    Store store(folder_);
    file(store, 2);
    file(store, 3);
  }
  damage_both_journals([&](const std::string&) { return std::string(first); });
  Store store(folder_);
  EXPECT_EQ(listing(store), kThree);
}

TEST_F(StoreTest, LinesThatAreNotKnownAreKept) {
  make(1);
  const std::string newer = checked_line(R"({"version":3,"number":77,"operations":[]})");
  damage_both_journals([&](const std::string& text) { return text + newer; });
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@1 = 1 head\n");
  EXPECT_TRUE(quarantined(newer));
}

TEST_F(StoreTest, AnAdoptedRevisionWhoseNumberIsTakenGetsTheNextOne) {
  make(2);
  {
    Store store(folder_);
    RevisionRecord same = record(5, "elsewhere");
    store.put(same, {.design = "d", .number = 2, .id = id(5)}, "", arrays_of(bytes_of(5)));
  }
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\nd@3 = 5\n");
}

TEST_F(StoreTest, AnAdoptedRevisionKeepsThePlaceThatTheJournalStillTells) {
  make(1);
  const std::string line = write_journal_line(
      {.number = 2, .transaction = {AddPlace{"d", 7, id(1)}, SetHead{"d", id(1)}}});
  damage_both_journals([&](const std::string&) { return std::string(line); });
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@7 = 1 head\n");
  EXPECT_EQ(read(store, 1), bytes_of(1));
}

TEST_F(StoreTest, APackOfAnUnfinishedRequestDoesNotTakeTheHeadOfAnotherBranch) {
  make(2);
  {
    Store store(folder_);
    RevisionRecord child = record(5, id(1));
    store.put(child, {.design = "d", .number = 3, .id = id(5)}, "", arrays_of(bytes_of(5)));
  }
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\nd@3 = 5\n");
}

TEST_F(StoreTest, APackUnderAnotherIdIsNotAdopted) {
  make(2);
  fs::create_directories(pack(7).parent_path());
  fs::copy_file(pack(1), pack(7));
  Store store(folder_);
  EXPECT_FALSE(has(store, 7));
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\n");
}

TEST_F(StoreTest, AMissingOrDamagedPackIsToldAndCanBeStoredAgain) {
  make(2);
  fs::remove(pack(1));
  flip_bit(pack(2), fs::file_size(pack(2)) - 1);
  Store store(folder_);
  for (int n = 1; n <= 2; ++n) {
    try {
      read(store, n);
      ADD_FAILURE() << "damaged bytes were served";
    } catch (const Error& failure) {
      EXPECT_EQ(failure.info().reason, "STORE_CORRUPTED");
      EXPECT_THAT(failure.info().message, Not(HasSubstr(folder_.string())));
    }
    RevisionRecord again = record(n);
    store.put(again, {.design = "d", .number = 1, .id = id(n)}, "", arrays_of(bytes_of(n)));
    EXPECT_EQ(read(store, n), bytes_of(n));
  }
}

TEST_F(StoreTest, TheJournalDoesNotGrowWithWhatIsNoMore) {
  Store store(folder_);
  for (int i = 0; i < 3000; ++i)
    store.commit([&](Catalogue&) {
      return Transaction{SetHead{"d", ""}, AddDesign{"d", static_cast<std::uint32_t>(i)}};
    });
  EXPECT_LT(fs::file_size(folder_ / "journal.a"), 200000U);
  EXPECT_EQ(store.read([](Catalogue& c) { return c.design("d")->next_number; }), 2999U);
}

TEST_F(StoreTest, InMemoryTheCatalogueIsTheSame) {
  Store store;
  file(store, 1);
  file(store, 2);
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\n");
  EXPECT_FALSE(store.persistent());
}

TEST_F(StoreTest, AFullDiskIsAnErrorThatSaysSo) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  File full("/dev/full", 1 /* O_WRONLY */);
  try {
    full.write("x");
    FAIL() << "/dev/full took a byte";
  } catch (const Error& error) {
    EXPECT_EQ(error.info().reason, "STORE_FULL");
    EXPECT_EQ(error.info().kind, ErrorKind::ResourceExhausted);
  }
}

}  // namespace
}  // namespace remeshd::test
