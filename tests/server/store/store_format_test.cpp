#include "server/store/store_format.h"

#include <gmock/gmock.h>

#include "engine/base/error.h"
#include "server/store/checked_line.h"
#include "tests/server/store/store_folder.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class StoreFormat : public StoreFolderTest {
 protected:
  void make_store(int revisions) {
    Store store(folder_);
    for (int n = 1; n <= revisions; ++n) file(store, n);
  }
  /// Opening must fail for that reason and change nothing.
  void expect_refused(const std::string& reason) {
    const auto before = files();
    try {
      const Store store(folder_);
      ADD_FAILURE() << "the folder was opened";
    } catch (const Error& failure) {
      EXPECT_EQ(failure.info().reason, reason);
      EXPECT_EQ(failure.info().kind, ErrorKind::FailedPrecondition);
      EXPECT_THAT(failure.info().message, testing::HasSubstr(folder_.string()));
      EXPECT_FALSE(failure.info().hint.empty());
    }
    EXPECT_EQ(files(), before);
  }
  static std::string format_line(int version) {
    return checked_line(R"({"store":"remeshd","version":)" + std::to_string(version) + "}");
  }
};

TEST_F(StoreFormat, AnEmptyFolderBecomesAStore) {
  fs::create_directory(folder_ / "lost+found");  // of a freshly made file system
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Empty);
  const Store store(folder_);
  EXPECT_TRUE(store.notes().empty());
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Store);
  EXPECT_EQ(content(folder_ / "FORMAT"), format_line(2));
}

TEST_F(StoreFormat, AFolderThatDoesNotExistIsMade) {
  const Store store(folder_ / "a" / "b");
  EXPECT_TRUE(fs::exists(folder_ / "a" / "b" / "FORMAT"));
}

TEST_F(StoreFormat, AGitRepositoryIsRefusedAndLeftAsItIs) {
  write(folder_ / "HEAD", "ref: refs/heads/main\n");
  write(folder_ / "objects" / "ab" / std::string(38, '1'), "x\x01zlib");
  write(folder_ / "objects" / "pack" / "pack-1.idx", "idx");
  write(folder_ / "refs" / "heads" / "main", std::string(40, 'a'));
  expect_refused("STORE_FOREIGN");
  expect_refused("STORE_FOREIGN");  // the second start is the one that deleted everything
}

TEST_F(StoreFormat, AFolderWithObjectsAloneIsRefused) {
  write(folder_ / "objects" / "ab" / std::string(62, '1'), "somebody's");
  expect_refused("STORE_FOREIGN");
}

TEST_F(StoreFormat, AFolderWithAFileIsRefused) {
  write(folder_ / "thesis.tex", "x");
  expect_refused("STORE_FOREIGN");
}

TEST_F(StoreFormat, AFolderWithAJournalOfAnotherProgramIsRefused) {
  write(folder_ / "journal", "Dear diary\n");
  expect_refused("STORE_FOREIGN");
}

TEST_F(StoreFormat, AFolderWithSomebodysFilesUnderNamesOfOursIsRefused) {
  for (const char* file : {"tmp/letter.txt", "tmp/12-34", "tmp/more/letter.txt",
                           "quarantine/letter.txt", "packs/x", "objects/x", "journal.a", "lock",
                           "FORMAT", "reserve", "index.sqlite", "index.sqlite-wal"}) {
    SCOPED_TRACE(file);
    write(folder_ / file, "somebody's");
    expect_refused("STORE_FOREIGN");
    fs::create_directories(folder_ / "objects");
    expect_refused("STORE_FOREIGN");
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  fs::create_symlink("/dev/null", folder_ / "lock");
  expect_refused("STORE_FOREIGN");
}

TEST_F(StoreFormat, AFirstOpeningThatACrashCutOffGoesOn) {
  const std::string line = format_line(2);
  const std::vector<std::string> on_the_disk{"", line.substr(0, 9), line,
                                             std::string(line.size(), '\0')};
  for (const std::string& bytes : on_the_disk) {
    fs::remove_all(folder_);
    write(folder_ / "lock", "");
    fs::create_directories(folder_ / "packs");
    write(folder_ / "tmp" / "123-4567890-0", bytes);
    Store store(folder_);
    EXPECT_TRUE(store.notes().empty());
    file(store, 1);
    EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
  }
}

TEST_F(StoreFormat, ADamagedFormatMayHaveBeenPutAwayBeforeACrash) {
  make_store(0);
  fs::remove(folder_ / "journal.a");
  fs::remove(folder_ / "journal.b");
  write(folder_ / "FORMAT", "damaged");
  fs::create_directory(folder_ / "quarantine");
  fs::rename(folder_ / "FORMAT", folder_ / "quarantine" / "store-FORMAT");
  const Store store(folder_);
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Store);
}

TEST_F(StoreFormat, ANewerStoreIsRefused) {
  make_store(1);
  write(folder_ / "FORMAT", format_line(3));
  expect_refused("STORE_NEWER");
}

TEST_F(StoreFormat, AnOlderStoreIsMarkedAsOneOfToday) {
  make_store(1);
  write(folder_ / "FORMAT", format_line(1));
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Older);
  Store store(folder_);
  EXPECT_TRUE(store.notes().empty());
  EXPECT_EQ(read(store, 1), bytes_of(1));
  EXPECT_EQ(content(folder_ / "FORMAT"), format_line(2));
}

TEST_F(StoreFormat, ANewerStoreWithoutItsFormatIsToldByItsPacks) {
  make_store(1);
  write(folder_ / "packs" / "ab" / std::string(62, 'c'),
        checked_line(R"({"format":"remeshd-pack","store":3,"what":"is not known"})") + "bytes");
  for (const char* format : {"", "damaged"}) {
    write(folder_ / "FORMAT", format);
    expect_refused("STORE_NEWER");
  }
}

TEST_F(StoreFormat, ADamagedOrMissingFormatIsWrittenAnew) {
  make_store(2);
  const std::string format = content(folder_ / "FORMAT");
  for (std::size_t byte = 0; byte < format.size(); ++byte) {
    flip_bit(folder_ / "FORMAT", byte, byte % 8);
    {
      Store store(folder_);
      EXPECT_EQ(read(store, 2), bytes_of(2)) << "byte " << byte;
    }
    EXPECT_EQ(content(folder_ / "FORMAT"), format);
  }
  fs::remove(folder_ / "FORMAT");
  Store store(folder_);
  EXPECT_EQ(listing(store), "d@1 = 1\nd@2 = 2 head\n");
  EXPECT_EQ(content(folder_ / "FORMAT"), format);
}

TEST_F(StoreFormat, AFormatThatTheDiskDoesNotGiveIsWrittenAnew) {
  for (const int revisions : {0, 2}) {
    fs::remove_all(folder_);
    make_store(revisions);
    const std::string format = content(folder_ / "FORMAT");
    for (const char* what : {"an error", "a folder"}) {
      SCOPED_TRACE(what + std::string(" over revisions: ") + std::to_string(revisions));
      fs::remove(folder_ / "FORMAT");
      if (what == std::string("a folder")) {
        fs::create_directory(folder_ / "FORMAT");
      } else {
        fs::create_symlink("/proc/self/mem", folder_ / "FORMAT");  // whose start cannot be read
      }
      const Store store(folder_);
      EXPECT_THAT(store.notes(), testing::Contains(testing::HasSubstr("FORMAT was moved")));
      EXPECT_EQ(content(folder_ / "FORMAT"), format);
    }
  }
}

TEST_F(StoreFormat, ANewerStoreIsToldByItsPacksWhereTheDiskDoesNotGiveItsFormat) {
  make_store(1);
  write(folder_ / "packs" / "ab" / std::string(62, 'c'),
        checked_line(R"({"format":"remeshd-pack","store":3,"what":"is not known"})") + "bytes");
  fs::remove(folder_ / "FORMAT");
  fs::create_symlink("/proc/self/mem", folder_ / "FORMAT");
  EXPECT_EQ(error_of([&] { look_at_folder(folder_); }).reason, "STORE_NEWER");
}

TEST_F(StoreFormat, AFormatOfOtherValuesCountsAsDamaged) {
  make_store(1);
  for (const char* text : {R"({"store":1,"version":2})", R"({"store":"remeshd","version":"2"})",
                           R"({"store":"remeshd","version":1e300})", R"({"version":2})", "[]"}) {
    write(folder_ / "FORMAT", checked_line(text));
    EXPECT_EQ(look_at_folder(folder_), FolderKind::Unmarked) << text;
  }
}

TEST_F(StoreFormat, AStoreInWhichNothingWasStoredIsKnownWithoutItsFormat) {
  make_store(0);
  write(folder_ / "FORMAT", "damaged");
  write(folder_ / "journal.a", "");
  write(folder_ / "journal.b", "");
  const Store store(folder_);
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Store);
}

TEST_F(StoreFormat, StoresOfTenantsBelowAreLeftAsTheyAre) {
  make_store(1);
  { const Store of_anna(folder_ / "tenants" / "anna"); }
  const auto tenant = content(folder_ / "tenants" / "anna" / "FORMAT");
  for (const char* damage : {"none", "FORMAT", "packs"}) {
    fs::remove_all(folder_ / damage);
    Store store(folder_);
    EXPECT_TRUE(store.notes().empty()) << store.notes().front();
    EXPECT_EQ(look_at_folder(folder_), FolderKind::Store);
  }
  EXPECT_EQ(content(folder_ / "tenants" / "anna" / "FORMAT"), tenant);
  EXPECT_FALSE(fs::exists(folder_ / "quarantine"));
}

TEST_F(StoreFormat, AFolderThatHasStoresOfTenantsAloneIsAStore) {
  { const Store of_anna(folder_ / "tenants" / "anna"); }
  fs::create_directory(folder_ / "tenants" / "ben");  // just being made
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Unmarked);
  const Store store(folder_);
  EXPECT_EQ(look_at_folder(folder_), FolderKind::Store);
}

TEST_F(StoreFormat, AFolderWithTenantsOfAnotherProgramIsRefused) {
  write(folder_ / "tenants" / "anna" / "letter.txt", "x");
  expect_refused("STORE_FOREIGN");
  fs::remove_all(folder_ / "tenants");
  write(folder_ / "tenants" / "list.txt", "anna");
  expect_refused("STORE_FOREIGN");
}

TEST_F(StoreFormat, AStoreInUseIsRefusedAndAnotherMayWaitForIt) {
  auto store = std::make_unique<Store>(folder_);
  expect_refused("STORE_LOCKED");
  store.reset();
  EXPECT_NO_THROW(Store(folder_, 5));
}

}  // namespace
}  // namespace remeshd::test
