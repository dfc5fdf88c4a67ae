#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "server/store/store.h"
#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

/// Packs of removed revisions: each stays as long as another one is told by it.
class LeftoversOfAStore : public StoreFolderTest {
 protected:
  /// So many that a long chain of packs is told by its first one.
  static std::string many_bytes(int n) {
    std::mt19937 random(1);
    std::string bytes(20000, ' ');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes + std::to_string(n);
  }
  /// A revision whose pack is told by that of `base`; 0: by none. Not committed.
  static RevisionRecord put(Store& store, int n, int base) {
    RevisionRecord added = record(n, base > 0 ? id(base) : "");
    const StoredArrays arrays = arrays_of(many_bytes(base));
    const Packs::Base on{id(base), &arrays};
    store.put(added, {.design = "d", .number = 1, .id = id(n)}, "", arrays_of(many_bytes(n)),
              base > 0 ? &on : nullptr);
    EXPECT_EQ(added.base, base > 0 ? id(base) : "");
    return added;
  }
  static void add(Store& store, int n, int base) {
    const RevisionRecord added = put(store, n, base);
    store.commit([&](Catalogue&) { return Transaction{AddRevision{added}}; });
  }
  int packs() const {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "packs"))
      count += entry.is_regular_file();
    return count;
  }
};

TEST_F(LeftoversOfAStore, OfALongChainGoWithTheOneThatStoodOnThem) {
  constexpr int kLast = 20;
  Store store(folder_);
  for (int n = 1; n <= kLast; ++n) add(store, n, n - 1);
  for (int n = kLast - 1; n >= 1; --n) remove(store, n);
  EXPECT_EQ(packs(), kLast);
  EXPECT_EQ(read(store, kLast), many_bytes(kLast));
  remove(store, kLast);
  EXPECT_EQ(packs(), 0);
}

TEST_F(LeftoversOfAStore, StayAsLongAsOneOfSeveralStandsOnThem) {
  Store store(folder_);
  add(store, 1, 0);
  for (const int n : {2, 3}) add(store, n, 1);
  for (const int n : {4, 5}) add(store, n, 2);
  for (const int n : {1, 2, 4}) remove(store, n);
  EXPECT_EQ(packs(), 4);
  EXPECT_EQ(read(store, 5), many_bytes(5));
  remove(store, 5);
  EXPECT_EQ(packs(), 2);
  EXPECT_EQ(read(store, 3), many_bytes(3));
  remove(store, 3);
  EXPECT_EQ(packs(), 0);
}

TEST_F(LeftoversOfAStore, StayForWhatIsNotCommittedYet) {
  Store store(folder_);
  add(store, 1, 0);
  const RevisionRecord added = put(store, 2, 1);
  remove(store, 1);
  EXPECT_EQ(packs(), 2);
  store.commit([&](Catalogue&) { return Transaction{AddRevision{added}}; });
  EXPECT_EQ(read(store, 2), many_bytes(2));
  remove(store, 2);
  EXPECT_EQ(packs(), 0);
}

}  // namespace
}  // namespace remeshd::test
