#include "server/store/packs.h"

#include <gmock/gmock.h>

#include "engine/base/error.h"
#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class PacksTest : public StoreFolderTest {
 protected:
  PacksTest() {
    fs::create_directories(folder_ / "packs");
    fs::create_directories(folder_ / "tmp");
  }
  std::string reason_of(int n) {
    try {
      static_cast<void>(packs_.get(id(n)));
      return "";
    } catch (const Error& failure) {
      return failure.info().reason;
    }
  }
  std::uint64_t put(const RevisionRecord& record, const std::string& bytes) {
    return packs_.put(record, place_, arrays_of(bytes), nullptr).bytes;
  }
  std::string bytes_of_pack(int n) { return packs_.get(id(n)).arrays.at(0).flat(); }

  Packs packs_{folder_ / "packs", folder_ / "tmp"};
  const PlaceRecord place_{.design = "d", .number = 3, .id = id(1)};
};

TEST_F(PacksTest, BytesAreReadBack) {
  const std::string bytes("abc\0\ndef", 8);
  const auto size = put(record(1), bytes);
  EXPECT_EQ(bytes_of_pack(1), bytes);
  EXPECT_EQ(size, fs::file_size(packs_.path_of(id(1))));
  EXPECT_EQ(packs_.list(), std::vector<std::string>{id(1)});
  EXPECT_TRUE(packs_.strangers().empty());
  EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
  packs_.remove(id(1));
  packs_.remove(id(1));
  EXPECT_TRUE(packs_.list().empty());
  EXPECT_EQ(reason_of(1), "StoreCorrupted");
}

TEST_F(PacksTest, TheHeadTellsWhatTheCatalogueKnew) {
  const auto size = put(record(1, "parent"), "abc");
  const auto head = packs_.head(id(1));
  ASSERT_TRUE(head);
  RevisionRecord expected = record(1, "parent");
  expected.created_ns = 0;  // which is not the bytes' own
  expected.bytes = size;
  EXPECT_EQ(head->record, expected);
  EXPECT_EQ(head->first, place_);
}

TEST_F(PacksTest, NoBitOfAFileMayChange) {
  put(record(1), "abcdefgh");
  const auto size = fs::file_size(packs_.path_of(id(1)));
  for (std::size_t byte = 0; byte < size; ++byte) {
    flip_bit(packs_.path_of(id(1)), byte, byte % 8);
    EXPECT_EQ(reason_of(1), "StoreCorrupted") << "byte " << byte;
    flip_bit(packs_.path_of(id(1)), byte, byte % 8);
  }
  EXPECT_EQ(bytes_of_pack(1), "abcdefgh");
}

TEST_F(PacksTest, AFileOfAnotherRevisionIsNotBelieved) {
  put(record(1), "abc");
  fs::create_directories(packs_.path_of(id(2)).parent_path());
  fs::rename(packs_.path_of(id(1)), packs_.path_of(id(2)));
  EXPECT_EQ(reason_of(2), "StoreCorrupted");
}

TEST_F(PacksTest, ADamagedFileIsReplaced) {
  put(record(1), "abc");
  write(packs_.path_of(id(1)), "damaged");
  put(record(1), "abc");
  EXPECT_EQ(bytes_of_pack(1), "abc");
}

TEST_F(PacksTest, OnlyTheOwnerMayReadAFile) {
  put(record(1), "abc");
  EXPECT_EQ(fs::status(packs_.path_of(id(1))).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(PacksTest, WhatIsNamedOtherwiseIsAStranger) {
  put(record(1), "abc");
  const std::vector<std::string> strange{"packs/README", "packs/12/short",
                                         "packs/ab/" + std::string(62, 'G'), "packs/long/file"};
  for (const std::string& name : strange) write(folder_ / name, "x");
  std::vector<std::string> found;
  for (const fs::path& path : packs_.strangers())
    found.push_back(fs::relative(path, folder_).string());
  EXPECT_THAT(found, testing::UnorderedElementsAre("packs/README", "packs/12/short", strange[2],
                                                   "packs/long"));
  EXPECT_EQ(packs_.list(), std::vector<std::string>{id(1)});
}

}  // namespace
}  // namespace remeshd::test
