#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/store/listing.h"
#include "server/store/records.h"
#include "server/store/sqlite.h"

namespace remeshd {

/// What revisions and designs there are: an index, in memory, over the transactions applied to it.
class Catalogue {
 public:
  Catalogue();

  /// All or nothing; what is there already is left as it is, so that a transaction may be applied
  /// again. Throws Error(`INDEX_FAILED`), also where a design's number is another revision's.
  void apply(const Transaction& transaction);
  /// Throws what `apply` would throw, and changes nothing.
  void check(const Transaction& transaction);
  /// Applies many, leaving out those that fail; how many did.
  std::size_t apply_all(const std::vector<Transaction>& transactions);
  /// Transactions that make an empty catalogue this one.
  std::vector<Transaction> snapshot();

  std::optional<RevisionRecord> revision(const std::string& id);
  /// Ids that begin with `prefix` (hexadecimal digits), at most `limit`, sorted.
  std::vector<std::string> with_prefix(const std::string& prefix, int limit);
  std::optional<std::string> at(const std::string& design, std::uint32_t number);
  /// Nothing for a design that was taken off the list.
  std::optional<DesignRecord> design(const std::string& name);
  /// The number of a design's next revision, also of one that is made again; 1 of a new one.
  std::uint32_t next_number(const std::string& design);
  /// The least number of a design that is left.
  std::optional<PlaceRecord> first_place(const std::string& design);
  /// By number.
  std::vector<PlaceRecord> places_of(const std::string& design);
  /// Where a revision stands, in the order in which it got there.
  std::vector<PlaceRecord> places(const std::string& id);
  /// The greatest number of a design that is not that of `except`.
  std::optional<PlaceRecord> last_place(const std::string& design, const std::string& except);
  /// A row for each place in a design, or for each revision in none.
  std::vector<ListedRevision> list(const RevisionFilter& filter, const RevisionPage& page);
  /// Designs without revisions too, but for those that were taken off the list.
  std::vector<DesignRecord> designs(const DesignFilter& filter, const DesignPage& page);
  /// Of all that are on the list.
  std::vector<std::string> design_names();
  std::vector<std::string> children(const std::string& id, int limit);
  /// Its recipe, be the revision deleted; empty where there is none.
  KeptRecipe recipe(const std::string& id);
  /// Recipes stand in the journal, all or none of these. Throws Error(`INDEX_FAILED`).
  void set_recipe_places(const std::vector<RecipePlace>& places);
  /// Ids of which there is a record or a recipe, at least half of them.
  std::uint64_t count_kept();
  /// Ids that have a recipe, with those of their parents.
  std::vector<std::pair<std::string, std::string>> recipes();
  /// All, by id.
  std::vector<RevisionRecord> revisions();
  /// Whether there is such a revision and it has a file.
  bool is_stored(const std::string& id);
  /// Revisions whose bytes are differences to those of `id`.
  std::vector<std::string> standing_on(const std::string& id);
  /// Whether a revision's bytes are differences to those of `id`.
  bool is_base(const std::string& id);
  std::uint32_t count_revisions();
  std::uint32_t count_designs();
  /// Of the files of all revisions.
  std::uint64_t count_bytes();

 private:
  void run(const Transaction& transaction, bool keep);
  void apply_one(const Operation& operation);
  void enter_design(const AddDesign& design);
  void keep_recipe(const KeepRecipe& recipe);
  void drop_recipe(std::string id);

  Sqlite database_;
};

}  // namespace remeshd
