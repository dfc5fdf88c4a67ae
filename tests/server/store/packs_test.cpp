#include "server/store/packs.h"

#include <gmock/gmock.h>

#include <random>

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
    return packs_.put(record, place_, "", arrays_of(bytes), nullptr).bytes;
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
  EXPECT_EQ(reason_of(1), "STORE_CORRUPTED");
}

TEST_F(PacksTest, TheHeadTellsWhatTheCatalogueKnew) {
  const auto size = put(record(1, "parent"), "abc");
  const auto head = packs_.head(id(1));
  ASSERT_TRUE(head);
  RevisionRecord expected = record(1, "parent");
  expected.bytes = size;
  EXPECT_EQ(head->record, expected);
  EXPECT_EQ(head->first, place_);
}

TEST_F(PacksTest, NoBitOfAFileMayChange) {
  put(record(1), "abcdefgh");
  const auto size = fs::file_size(packs_.path_of(id(1)));
  for (std::size_t byte = 0; byte < size; ++byte) {
    flip_bit(packs_.path_of(id(1)), byte, byte % 8);
    EXPECT_EQ(reason_of(1), "STORE_CORRUPTED") << "byte " << byte;
    flip_bit(packs_.path_of(id(1)), byte, byte % 8);
  }
  EXPECT_EQ(bytes_of_pack(1), "abcdefgh");
}

TEST_F(PacksTest, AFileOfAnotherRevisionIsNotBelieved) {
  put(record(1), "abc");
  fs::create_directories(packs_.path_of(id(2)).parent_path());
  fs::rename(packs_.path_of(id(1)), packs_.path_of(id(2)));
  EXPECT_EQ(reason_of(2), "STORE_CORRUPTED");
}

TEST_F(PacksTest, AFileWhoseBaseIsNoRevisionIsDamaged) {
  for (const char* base : {"x", "../../tmp/somewhere"}) {
    PackHead head{.record = record(1), .base_content = "c", .data = content_hash("")};
    head.record.base = base;
    write(packs_.path_of(id(1)), write_pack_head(head));
    EXPECT_EQ(reason_of(1), "STORE_CORRUPTED");
    EXPECT_NE(packs_.fault_of(id(1)), "");
    EXPECT_FALSE(packs_.is_whole(id(1)));
  }
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

/// A chain of revisions, each with a little changed.
class PackChain : public PacksTest {
 protected:
  static StoredArrays big(const std::string& bytes) {
    StoredArray array{.name = "mesh", .type = StoredType::I32};
    array.own(bytes);
    return {{std::move(array)}};
  }
  PackChain() : bytes_(400000, 'x') {
    for (std::size_t i = 0; i < bytes_.size(); ++i) bytes_[i] = static_cast<char>(random_() % 251);
  }
  Packs::Written add(int n) {
    const StoredArrays before = big(bytes_);
    if (n > 1)
      for (int i = 0; i < 40; ++i) bytes_[4 * (random_() % 20000)] ^= 1;
    all_.push_back(bytes_);
    const Packs::Base base{id(n - 1), &before};
    return packs_.put(record(n), place_, "", big(bytes_), n > 1 ? &base : nullptr);
  }
  std::string mesh(int n) { return packs_.get(id(n)).arrays.at(0).flat(); }

  std::mt19937 random_{5};
  std::string bytes_;
  std::vector<std::string> all_;
};

TEST_F(PackChain, CostsWhatChanges) {
  const auto first = add(1);
  EXPECT_EQ(first.base, "");
  EXPECT_GT(first.bytes, 300000U);
  const auto second = add(2);
  EXPECT_EQ(second.base, id(1));
  EXPECT_LT(second.bytes, 3000U);
}

TEST_F(PackChain, EveryRevisionOfALongOneIsReadBack) {
  for (int n = 1; n <= 150; ++n) add(n);
  for (int n = 1; n <= 150; ++n) ASSERT_TRUE(mesh(n) == all_[n - 1]) << n;
  Packs reopened(folder_ / "packs", folder_ / "tmp");
  for (const int n : {1, 64, 65, 66, 150})
    EXPECT_TRUE(reopened.get(id(n)).arrays.at(0).flat() == all_[n - 1]);
  // No pack takes more than so many others.
  for (int n = 1; n <= 150; ++n) EXPECT_LE(packs_.head(id(n))->chain, 64U);
}

TEST_F(PackChain, GoesOnAfterAnotherOpening) {
  for (int n = 1; n <= 12; ++n) add(n);
  const StoredArrays before = big(bytes_);
  bytes_[0] ^= 1;
  Packs reopened(folder_ / "packs", folder_ / "tmp");
  const Packs::Base base{id(12), &before};
  EXPECT_EQ(reopened.put(record(13), place_, "", big(bytes_), &base).base, id(12));
  EXPECT_TRUE(reopened.get(id(13)).arrays.at(0).flat() == bytes_);
}

TEST_F(PackChain, ABaseThatIsGoneOrDamagedOrNotWhatItWasIsNotTaken) {
  add(1);
  const StoredArrays before = big(bytes_);
  const StoredArrays other = big(std::string(400000, 'y'));
  const Packs::Base not_it{id(1), &other};
  EXPECT_EQ(packs_.put(record(2), place_, "", before, &not_it).base, "");
  const Packs::Base nowhere{id(9), &before};
  EXPECT_EQ(packs_.put(record(2), place_, "", before, &nowhere).base, "");
  flip_bit(packs_.path_of(id(1)), fs::file_size(packs_.path_of(id(1))) - 5);
  Packs reopened(folder_ / "packs", folder_ / "tmp");
  const Packs::Base damaged{id(1), &before};
  EXPECT_EQ(reopened.put(record(2), place_, "", before, &damaged).base, "");
}

TEST_F(PackChain, DamageToABaseIsToldOfWhatStandsOnIt) {
  for (int n = 1; n <= 4; ++n) add(n);
  flip_bit(packs_.path_of(id(2)), fs::file_size(packs_.path_of(id(2))) - 5);
  EXPECT_EQ(reason_of(1), "");
  for (int n = 2; n <= 4; ++n) EXPECT_EQ(reason_of(n), "STORE_CORRUPTED") << n;
  // Stored again, by itself, it is what the others stand on as before.
  packs_.put(record(2), place_, "", big(all_[1]), nullptr);
  for (int n = 1; n <= 4; ++n) EXPECT_TRUE(mesh(n) == all_[n - 1]);
}

TEST_F(PackChain, ABaseWithOtherContentIsNotBelieved) {
  for (int n = 1; n <= 3; ++n) add(n);
  packs_.put(record(2), place_, "", big(std::string(400000, 'z')), nullptr);
  EXPECT_EQ(reason_of(3), "STORE_CORRUPTED");
}

}  // namespace
}  // namespace remeshd::test
