#include "server/store/journal.h"

#include <gmock/gmock.h>

#include "engine/base/error.h"
#include "server/store/checked_line.h"
#include "tests/server/store/store_folder.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class JournalTest : public StoreFolderTest {
 protected:
  JournalTest() { fs::create_directories(scratch_); }

  Journal open() { return {folder_, scratch_}; }
  Journal fresh() {
    Journal journal = open();
    rewrite(journal, {});
    return journal;
  }
  static std::vector<RecipePlace> rewrite(Journal& journal,
                                          const std::vector<Transaction>& transactions) {
    std::vector<RecipePlace> moved;
    journal.rewrite(transactions, [&](const std::vector<RecipePlace>& places) { moved = places; });
    return moved;
  }
  /// Of the n-th transaction's first operation.
  static JournalPlace place_of_recipe(Journal& journal, std::size_t n) {
    auto all = journal.take_transactions();
    return recipe_in(all.at(n).at(0)).recipe->place.value();
  }
  static void append(Journal& journal, const std::string& id) {
    journal.append({RemoveRevision{id}});
  }
  static std::vector<std::string> ids(Journal&& journal) {
    std::vector<std::string> found;
    for (const Transaction& transaction : journal.take_transactions())
      for (const Operation& operation : transaction)
        found.push_back(std::get<RemoveRevision>(operation).id);
    return found;
  }
  /// Where each line of a file begins.
  static std::vector<std::size_t> starts(const std::string& text) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < text.size(); i = text.find('\n', i) + 1) at.push_back(i);
    return at;
  }

  const fs::path scratch_ = folder_ / "tmp";
  const fs::path first_ = folder_ / "journal.a", second_ = folder_ / "journal.b";
};

TEST_F(JournalTest, GivesEveryOperationBack) {
  RevisionRecord r = record(1, "parent");
  r.bytes = 9;
  {
    Journal journal = fresh();
    journal.append({AddRevision{r}, AddPlace{"d", 1, r.id}, SetHead{"d", r.id}});
    journal.append({RemovePlace{"d", 1}, RemoveRevision{r.id}});
    journal.append({StartAnew{}, AddDesign{"e", 7}});
  }
  Journal journal = open();
  EXPECT_TRUE(journal.whole());
  const auto all = journal.take_transactions();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(std::get<AddRevision>(all[0][0]).record, r);
  EXPECT_EQ(std::get<AddPlace>(all[0][1]).number, 1U);
  EXPECT_EQ(std::get<SetHead>(all[0][2]).id, r.id);
  EXPECT_EQ(std::get<RemovePlace>(all[1][0]).design, "d");
  EXPECT_EQ(std::get<RemoveRevision>(all[1][1]).id, r.id);
  EXPECT_TRUE(std::holds_alternative<StartAnew>(all[2][0]));
  EXPECT_EQ(std::get<AddDesign>(all[2][1]).next_number, 7U);
}

TEST_F(JournalTest, AnyBitOfEitherFileMayChange) {
  {
    Journal journal = fresh();
    for (const char* id : {"aa", "bb", "cc"}) append(journal, id);
  }
  const std::string text = content(first_);
  ASSERT_EQ(content(second_), text);
  for (const fs::path& file : {first_, second_})
    for (std::size_t byte = 0; byte < text.size(); ++byte) {
      flip_bit(file, byte, byte % 8);
      Journal journal = open();
      EXPECT_FALSE(journal.whole()) << byte;
      EXPECT_EQ(journal.lost(), 0U);
      EXPECT_THAT(ids(std::move(journal)), ElementsAre("aa", "bb", "cc"))
          << file << " byte " << byte;
      write(file, text);
    }
}

TEST_F(JournalTest, ANumberThatChangedToAnotherNumberIsNotBelieved) {
  {
    Journal journal = fresh();
    journal.append({AddPlace{"d", 4, "aa"}});
  }
  for (const fs::path& file : {first_, second_}) {
    std::string text = content(file);
    const std::size_t at = text.find("\"number\":4");
    ASSERT_NE(at, std::string::npos);
    text[at + 9] = '5';  // JSON all the same
    write(file, text);
  }
  Journal journal = open();
  EXPECT_THAT(journal.unreadable(), testing::HasSubstr("\"number\":5"));
  EXPECT_TRUE(journal.take_transactions().empty());
}

TEST_F(JournalTest, EachFileMayBeCutOffAnywhereOrMissing) {
  {
    Journal journal = fresh();
    for (const char* id : {"aa", "bb"}) append(journal, id);
  }
  const std::string text = content(first_);
  for (const fs::path& file : {first_, second_}) {
    for (std::size_t size = 0; size < text.size(); size += 3) {
      write(file, text.substr(0, size));
      EXPECT_THAT(ids(open()), ElementsAre("aa", "bb")) << file << " cut at " << size;
    }
    fs::remove(file);
    EXPECT_THAT(ids(open()), ElementsAre("aa", "bb"));
    write(file, text);
  }
}

TEST_F(JournalTest, AnUnfinishedLastLineIsReportedAndNothingIsChanged) {
  {
    Journal journal = fresh();
    append(journal, "aa");
  }
  const std::string text = content(first_);
  write(first_, text + "0123abcd {\"vers");
  const auto before = files();
  Journal journal = open();
  EXPECT_FALSE(journal.whole());
  EXPECT_EQ(journal.unreadable(), "0123abcd {\"vers\n");
  EXPECT_THAT(ids(std::move(journal)), ElementsAre("aa"));
  EXPECT_EQ(files(), before);
}

TEST_F(JournalTest, AnOlderFirstFileLosesNothing) {
  Journal journal = fresh();
  append(journal, "aa");
  const std::string older = content(first_);
  append(journal, "bb");
  write(first_, older);
  EXPECT_THAT(ids(open()), ElementsAre("aa", "bb"));
}

TEST_F(JournalTest, LinesLostInBothFilesAreCounted) {
  {
    Journal journal = fresh();
    for (const char* id : {"aa", "bb", "cc", "dd"}) append(journal, id);
  }
  for (const fs::path& file : {first_, second_}) {
    const std::string text = content(file);
    const auto lines = starts(text);
    write(file, text.substr(0, lines[1]) + text.substr(lines[3]));
  }
  Journal journal = open();
  EXPECT_EQ(journal.lost(), 2U);
  EXPECT_THAT(ids(std::move(journal)), ElementsAre("aa", "dd"));
}

TEST_F(JournalTest, ALineOfANewerVersionIsKeptForTheQuarantine) {
  {
    Journal journal = fresh();
    append(journal, "aa");
  }
  const std::string newer = checked_line(R"({"version":3,"number":9,"operations":[]})");
  const std::string unknown =
      checked_line(R"({"version":2,"number":10,"operations":[{"paint":"red"}]})");
  for (const fs::path& file : {first_, second_}) write(file, content(file) + newer + unknown);
  Journal journal = open();
  EXPECT_FALSE(journal.whole());
  EXPECT_EQ(journal.unreadable(), newer + unknown);
  EXPECT_THAT(ids(std::move(journal)), ElementsAre("aa"));
}

TEST_F(JournalTest, RewritingReplacesBothAndGoesOn) {
  {
    Journal journal = fresh();
    for (const char* id : {"aa", "bb"}) append(journal, id);
    rewrite(journal, {{RemoveRevision{"cc"}}});
    EXPECT_EQ(journal.lines(), 1U);
    append(journal, "dd");
  }
  Journal journal = open();
  EXPECT_TRUE(journal.whole());
  EXPECT_THAT(ids(std::move(journal)), ElementsAre("cc", "dd"));
}

TEST_F(JournalTest, ARewriteThatOnlyTheFirstFileSawIsComplete) {
  Journal journal = fresh();
  append(journal, "aa");
  const std::string before = content(second_);
  rewrite(journal, {{StartAnew{}}, {RemoveRevision{"bb"}}});
  write(second_, before);
  Journal opened = open();
  const auto all = opened.take_transactions();
  ASSERT_EQ(all.size(), 3U);  // the old line, then what replaces everything
  EXPECT_TRUE(std::holds_alternative<StartAnew>(all[1][0]));
  EXPECT_EQ(std::get<RemoveRevision>(all[2][0]).id, "bb");
}

TEST_F(JournalTest, RecipesAreLeftInTheFile) {
  JournalPlace place;
  {
    Journal journal = fresh();
    append(journal, "aa");
    place = journal.append({AddRevision{record(1), {"one"}}, KeepRecipe{"bb", "", {"two"}}});
    EXPECT_EQ(journal.recipe(id(1), place), "one");
    EXPECT_EQ(journal.recipe("bb", place), "two");
    EXPECT_EQ(journal.recipe("cc", place), "");
  }
  Journal journal = open();
  EXPECT_EQ(journal.recipe(id(1), place), "one");
  EXPECT_EQ(place_of_recipe(journal, 1), place);
}

TEST_F(JournalTest, ARecipeWithoutTextIsStillARecipeOfTheLine) {
  Journal journal = fresh();
  const JournalPlace place = journal.append({KeepRecipe{"bb", "aa", {}}});
  EXPECT_EQ(journal.recipe("bb", place), "");
  Journal again = open();
  EXPECT_EQ(std::get<KeepRecipe>(again.take_transactions().at(0).at(0)).parent, "aa");
}

TEST_F(JournalTest, ARecipeThatIsDamagedInOneFileIsReadInTheOther) {
  Journal journal = fresh();
  const JournalPlace place = journal.append({KeepRecipe{"bb", "", {"text"}}});
  flip_bit(first_, place.start + place.length / 2);
  EXPECT_EQ(open().recipe("bb", place), "text");
  flip_bit(second_, place.start + 4);
  EXPECT_EQ(open().recipe("bb", place), "");
}

TEST_F(JournalTest, RecipesThatOnlyTheSecondFileHasAreRead) {
  {
    Journal journal = fresh();
    append(journal, "aa");
    journal.append({KeepRecipe{"bb", "", {"text"}}});
  }
  fs::remove(first_);
  Journal journal = open();
  const auto all = journal.take_transactions();
  EXPECT_EQ(std::get<KeepRecipe>(all.at(1).at(0)).recipe, KeptRecipe("text"));
}

TEST_F(JournalTest, RewritingTakesRecipesAlongAndTellsTheirPlaces) {
  Journal journal = fresh();
  append(journal, "aa");
  const JournalPlace place = journal.append({AddRevision{record(1), {"one"}}});
  const auto moved = rewrite(journal, {{AddRevision{record(1), {place}}, AddPlace{"d", 1, id(1)}},
                                       {KeepRecipe{"bb", id(1), {"two"}}}});
  ASSERT_EQ(moved.size(), 2U);
  EXPECT_EQ(moved[0].id, id(1));
  EXPECT_NE(moved[0].line, place);
  EXPECT_EQ(journal.recipe(id(1), moved[0].line), "one");
  EXPECT_EQ(journal.recipe("bb", moved[1].line), "two");
  Journal again = open();
  EXPECT_TRUE(again.whole());
  EXPECT_EQ(again.recipe(id(1), moved[0].line), "one");
  EXPECT_EQ(place_of_recipe(again, 1), moved[1].line);
}

TEST_F(JournalTest, PlacesStandUntilWhoeverHasThemKnowsTheNewOnes) {
  Journal journal = fresh();
  append(journal, "aa");
  const JournalPlace place = journal.append({KeepRecipe{"bb", "", {"text"}}});
  const Transaction kept{KeepRecipe{"bb", "", {place}}};
  const auto fails = [](const std::vector<RecipePlace>&) { throw std::bad_alloc(); };
  EXPECT_THROW(journal.rewrite({kept}, fails), std::bad_alloc);
  EXPECT_TRUE(journal.uncertain());
  EXPECT_EQ(journal.recipe("bb", place), "text");
  const auto moved = rewrite(journal, {kept});
  EXPECT_FALSE(journal.uncertain());
  EXPECT_EQ(journal.recipe("bb", moved.at(0).line), "text");
}

TEST_F(JournalTest, ALineMayBeLongerThanWhatIsReadAtATime) {
  const std::string large(std::size_t{1} << 20, 'x');
  JournalPlace place;
  {
    Journal journal = fresh();
    append(journal, "aa");
    place = journal.append({KeepRecipe{"bb", "", {large}}});
    append(journal, "cc");
  }
  Journal journal = open();
  EXPECT_TRUE(journal.whole());
  EXPECT_EQ(journal.lines(), 3U);
  EXPECT_EQ(journal.recipe("bb", place), large);
}

}  // namespace
}  // namespace remeshd::test
