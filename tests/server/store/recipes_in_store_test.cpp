#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>
#include <map>

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
  /// How often the journal is rewritten while `change` is called with these numbers.
  int rewritten(int first, int last, const std::function<void(int)>& change) const {
    const auto inode = [&] {
      struct stat found {};
      EXPECT_EQ(::stat((folder_ / "journal.a").c_str(), &found), 0);
      return found.st_ino;
    };
    int times = 0;
    for (int n = first; n < last; ++n) {
      const auto before = inode();
      change(n);
      times += inode() != before;
    }
    return times;
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
  EXPECT_LE(rewritten(1200, 1230, [&](int n) { replace(store, n); }), 1);
}

TEST_F(RecipesInTheStore, AreNotAllThatKeepsTheJournalFromBeingRewrittenEveryTime) {
  const auto design = [](int n) { return "d" + std::to_string(n); };
  const std::map<std::string, std::function<Transaction(int)>> kinds{
      {"designs", [&](int n) { return Transaction{AddDesign{.name = design(n)}}; }},
      {"designs off the list",
       [&](int n) { return Transaction{AddDesign{.name = design(n), .listed = false}}; }},
      {"places of one revision",
       [&](int n) {
         return Transaction{AddPlace{.design = "d", .number = n + 1U, .id = id(n % 2)},
                            RemovePlace{.design = "d", .number = n + 0U}};
       }},
      {"heads of designs", [&](int n) {
         return Transaction{AddPlace{.design = design(n), .number = 1, .id = id(0)},
                            SetHead{.design = design(n), .id = id(0)}};
       }}};
  for (const auto& [what, change] : kinds) {
    std::filesystem::remove_all(folder_);
    Store store(folder_);
    for (int n = 0; n < 2; ++n)
      store.commit([&](Catalogue&) { return Transaction{AddRevision{record(n)}}; });
    const auto commit = [&](int n) { store.commit([&](Catalogue&) { return change(n); }); };
    EXPECT_LE(rewritten(0, 1500, commit), 1) << what;
  }
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
