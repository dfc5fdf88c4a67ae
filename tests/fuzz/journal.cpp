// Recovery of a store from its journal and its FORMAT: what stands in these files, whatever it is,
// a store opens or is refused by name, and a second opening finds what the first one found. The
// first byte says how the text after it becomes files.
#include <algorithm>

#include "engine/base/error.h"
#include "server/store/checked_line.h"
#include "server/store/journal_line.h"
#include "server/store/packed_text.h"
#include "server/store/store.h"
#include "server/store/store_format.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/scratch_folder.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

constexpr std::uint8_t kChecksums = 1;  // put before every line
constexpr std::uint8_t kFormat = 2;     // the first line is FORMAT's
constexpr std::uint8_t kCopy = 4;       // a line alone of `=` stands before the second file's text
constexpr std::uint8_t kFirstLayout = 8;  // the journal of the first layout
constexpr std::uint8_t kStore = 16;       // open all of the store, which takes longer

std::string lines_of(std::string_view text, bool checksums) {
  if (!checksums) return std::string(text);
  std::string out;
  Input input(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  while (!input.empty()) out += checked_line(input.until('\n'));
  return out;
}

void write_files(std::uint8_t how, Input input, const ScratchFolder& folder) {
  const bool checksums = (how & kChecksums) != 0;
  if ((how & kFormat) != 0)
    folder.write("FORMAT", lines_of(input.until('\n'), checksums));
  else
    write_format(folder.path(), folder.path());
  const std::string_view text = input.rest();
  const std::size_t cut = (how & kCopy) != 0 ? text.find("\n=\n") : std::string_view::npos;
  const std::string first = lines_of(text.substr(0, cut), checksums);
  if ((how & kFirstLayout) != 0) {
    folder.write("journal", first);
    return;
  }
  folder.write("journal.a", first);
  folder.write("journal.b",
               cut == std::string_view::npos ? first : lines_of(text.substr(cut + 3), checksums));
}

/// Every line that is written is read as it was.
void check_lines(const std::vector<Transaction>& transactions) {
  for (const Transaction& transaction : transactions) {
    const std::string line = write_journal_line({.number = 7, .transaction = transaction});
    const auto read = read_journal_line(line);
    expect(read.has_value(), "a line of the journal that is written and not read: " + line);
    expect(write_journal_line(*read) == line, "a line of the journal is read as another: " + line);
  }
}

std::string text_of(const std::vector<Transaction>& transactions) {
  std::string text;
  for (const Transaction& transaction : transactions)
    text += write_journal_line({.number = 1, .transaction = transaction});
  return text;
}

/// An empty catalogue: the same one anew, for to make one takes longer than to fill it.
Catalogue& emptied(Catalogue& catalogue) {
  catalogue.apply({StartAnew{}});
  return catalogue;
}

/// The same with the recipes that are told by their place, as `read` gives them.
template <typename Read>
std::vector<Transaction> with_recipes(std::vector<Transaction> transactions, const Read& read) {
  for (Transaction& transaction : transactions)
    for (Operation& operation : transaction)
      if (const auto [id, recipe] = recipe_in(operation); id != nullptr && recipe->place)
        *recipe = KeptRecipe(read(*id, *recipe->place));
  return transactions;
}

/// A catalogue tells itself in transactions that make it again.
std::vector<Transaction> checked_snapshot(Catalogue& catalogue) {
  std::vector<Transaction> all = catalogue.snapshot();
  static Catalogue other;
  Catalogue& again = emptied(other);
  expect(again.apply_all(all) == 0, "a catalogue that cannot be made again");
  expect(text_of(again.snapshot()) == text_of(all), "a catalogue is made again as another");
  for (const RevisionRecord& record : catalogue.revisions()) {
    catalogue.places(record.id);
    catalogue.children(record.id, 10);
    catalogue.recipe(record.id);
  }
  catalogue.list({}, {});
  catalogue.designs({}, {});
  return all;
}

void check_journal(const ScratchFolder& folder) {
  Journal journal(folder.path(), folder.path());
  const std::uint64_t lines = journal.lines();
  const std::vector<Transaction> read = journal.take_transactions();
  expect(read.size() == lines, "a line of the journal is counted and not given");
  const auto recipe_of = [](const Journal& from) {
    return [&](const std::string& id, const JournalPlace& line) { return from.recipe(id, line); };
  };
  check_lines(with_recipes(read, recipe_of(journal)));
  static Catalogue all_read;
  Catalogue& catalogue = emptied(all_read);
  catalogue.apply_all(read);
  const std::string all = text_of(with_recipes(checked_snapshot(catalogue), recipe_of(journal)));
  journal.rewrite(catalogue.snapshot(), [&](const std::vector<RecipePlace>& places) {
    catalogue.set_recipe_places(places);
  });
  expect(text_of(with_recipes(catalogue.snapshot(), recipe_of(journal))) == all,
         "a recipe is another once the journal was rewritten");
  Journal again(folder.path(), folder.path());
  expect(again.whole(), "a journal that was rewritten is not whole");
  expect(text_of(with_recipes(again.take_transactions(), recipe_of(again))) == all,
         "a journal is rewritten as another");
}

void check_store(const ScratchFolder& folder) {
  std::string found;
  for (int opening = 0; opening < 2; ++opening) {
    Store store(folder.path());
    const auto recipe_of = [&](const std::string& id, const JournalPlace&) -> std::string {
      try {
        return store.recipe(id);
      } catch (const Error&) {
        return "no recipe";
      }
    };
    const std::string all = text_of(with_recipes(store.read(checked_snapshot), recipe_of));
    expect(opening == 0 || all == found, "a store that is opened again is another");
    found = all;
  }
}

void check(Input input) {
  const ScratchFolder folder;
  const std::uint8_t how = input.byte();
  write_files(how, input, folder);
  if ((how & (kStore | kFirstLayout | kFormat)) != 0)
    check_store(folder);
  else
    check_journal(folder);
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_journal(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  try {
    fuzz::check({data, size});
  } catch (const Error& error) {
    const std::string& reason = error.info().reason;
    fuzz::expect(reason == "STORE_NEWER" || reason == "STORE_FOREIGN",
                 "a store that does not open: " + error.info().message);
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::journal_seeds() {
  const std::string id(64, 'a'), next(64, 'b');
  const std::vector<Transaction> all{
      {AddRevision{{.id = id, .model_name = "m", .created_ns = 5, .nodes = 7, .bytes = 100},
                   packed("a recipe")},
       AddPlace{"plate", 1, id}, SetHead{"plate", id}},
      {AddRevision{{.id = next,
                    .parent = id,
                    .root = id,
                    .model_name = "m",
                    .bytes = 10,
                    .base = id,
                    .seconds = {0.5, 1.5}}},
       AddPlace{"plate", 2, next}, SetPin{next, true}},
      {RemovePlace{"plate", 1}, RemoveRevision{id}, KeepRecipe{id, "", packed("a recipe")}},
      {AddDesign{"other", 4, 9, false}, DropMesh{next}},
      {StartAnew{}},
      {AddRevision{{.id = id, .model_name = "n"}}}};
  Seeds seeds;
  std::string texts, lines;
  for (std::uint64_t number = 1; const Transaction& transaction : all) {
    const std::string line = write_journal_line({number++, transaction});
    lines += line;
    texts += line.substr(line.find('{'));
    seeds.push_back(static_cast<char>(kChecksums) + line.substr(line.find('{')));
  }
  seeds.push_back('\0' + lines);
  seeds.push_back(static_cast<char>(kStore) + lines);
  seeds.push_back(static_cast<char>(kChecksums) + texts);
  seeds.push_back(static_cast<char>(kCopy) + lines.substr(0, 300) + "\n=\n" + lines);
  seeds.push_back(static_cast<char>(kChecksums | kFormat) +
                  std::string("{\"store\":\"remeshd\",\"version\":1}\n") + texts);
  seeds.push_back(static_cast<char>(kFormat) + std::string("damaged\n") + lines);
  seeds.push_back(
      static_cast<char>(kChecksums | kFirstLayout | kFormat) +
      std::string("{}\n[{\"add_revision\":\"") + id +
      R"(","parent":"","model_name":"m","created_ns":1,"nodes":1,"tets":1,"bytes":3}])");
  return seeds;
}
