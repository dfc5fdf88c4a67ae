#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "server/store/store.h"
#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

/// A chain of revisions of which only the last is left, with the recipes of all.
class RecipesInTheStore : public StoreFolderTest {
 protected:
  static std::string recipe_of(int n) { return "recipe " + std::to_string(n); }
  /// The n-th revision, without a mesh, in place of the one before.
  static void replace(Store& store, int n) {
    RevisionRecord added = record(n, n > 0 ? id(n - 1) : "");
    added.created_ns = 0;
    store.commit([&](Catalogue&) {
      Transaction changes{AddRevision{added, Store::packed_recipe(recipe_of(n))}};
      if (n > 0) changes.emplace_back(RemoveRevision{id(n - 1)});
      return changes;
    });
  }
  static KeptRecipe kept(Store& store, int n) {
    return store.read([&](Catalogue& catalogue) { return catalogue.recipe(id(n)); });
  }
};

TEST_F(RecipesInTheStore, AreInTheJournalAndNotInMemory) {
  {
    Store store(folder_);
    for (int n = 0; n < 3; ++n) replace(store, n);
    for (int n = 0; n < 3; ++n) {
      EXPECT_TRUE(kept(store, n).bytes.empty());
      EXPECT_EQ(store.recipe(id(n)), recipe_of(n));
    }
  }
  Store store(folder_);
  for (int n = 0; n < 3; ++n) {
    EXPECT_TRUE(kept(store, n).bytes.empty());
    EXPECT_EQ(store.recipe(id(n)), recipe_of(n));
  }
}

TEST_F(RecipesInTheStore, AreFoundAgainWhateverRewritesTheJournal) {
  constexpr int kLast = 4000;  // lines enough for a journal to be rewritten several times
  {
    Store store(folder_);
    for (int n = 0; n < 5; ++n) replace(store, n);
    for (int i = 0; i < kLast; ++i)
      store.commit([&](Catalogue&) { return Transaction{SetHead{"d", ""}}; });
    for (int n = 0; n < 5; ++n) EXPECT_EQ(store.recipe(id(n)), recipe_of(n));
    replace(store, 5);
  }
  EXPECT_LT(fs::file_size(folder_ / "journal.a"), 200000U);
  fs::remove(folder_ / "journal.a");  // rewritten on opening from the second file
  Store store(folder_);
  for (int n = 0; n <= 5; ++n) {
    EXPECT_TRUE(kept(store, n).bytes.empty());
    EXPECT_EQ(store.recipe(id(n)), recipe_of(n));
  }
}

TEST_F(RecipesInTheStore, OfWhatIsNoMoreDoNotHaveTheJournalRewrittenEveryTime) {
  Store store(folder_);
  for (int n = 0; n < 1200; ++n) replace(store, n);
  const auto inode = [&] {
    struct stat found {};
    EXPECT_EQ(::stat((folder_ / "journal.a").c_str(), &found), 0);
    return found.st_ino;
  };
  int rewritten = 0;
  for (int n = 1200; n < 1230; ++n) {
    const auto before = inode();
    replace(store, n);
    rewritten += inode() != before;
  }
  EXPECT_LE(rewritten, 1);
}

TEST_F(RecipesInTheStore, AreTakenFromTheSecondJournalOrThePackWhereTheFirstIsDamaged) {
  RevisionRecord added = record(1);
  Store store(folder_);
  store.put(added, {.design = "d", .number = 1, .id = id(1)}, recipe_of(1), arrays_of("x"));
  store.commit([&](Catalogue&) {
    return Transaction{AddRevision{added, Store::packed_recipe(recipe_of(1))}};
  });
  const JournalPlace line = kept(store, 1).place.value();
  for (const char* name : {"journal.a", "journal.b"}) {
    std::fstream file(folder_ / name, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(line.start + line.length / 2));
    file.put('\0');
    file.close();
    EXPECT_EQ(store.recipe(id(1)), recipe_of(1)) << name;
  }
}

}  // namespace
}  // namespace remeshd::test
