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

/// The revisions and designs that there are: an index in memory (SQLite) of the transactions
/// applied to it. Not thread-safe.
class Catalogue {
 public:
  Catalogue();

  /// All or nothing. A transaction may be applied again, without effect; AddRevision of an id that
  /// is there replaces its record. Throws Error(`INDEX_FAILED`), also where a design's number is
  /// another revision's.
  void apply(const Transaction& transaction);
  /// Throws what `apply` would throw, and changes nothing.
  void check(const Transaction& transaction);
  /// Applies transactions, leaving out those that fail; returns how many failed.
  std::size_t apply_all(const std::vector<Transaction>& transactions);
  /// Transactions that make any catalogue a copy of this one.
  std::vector<Transaction> snapshot();

  std::optional<RevisionRecord> revision(const std::string& id);
  /// Ids that begin with `prefix` (hexadecimal digits), at most `limit`, sorted.
  std::vector<std::string> with_prefix(const std::string& prefix, int limit);
  std::optional<std::string> at(const std::string& design, std::uint32_t number);
  /// Nothing for a design that does not exist or was taken off the list.
  std::optional<DesignRecord> design(const std::string& name);
  /// The number that a design's next revision gets; 1 for a new design. One that was taken off the
  /// list goes on counting if it is made again.
  std::uint32_t next_number(const std::string& design);
  /// The place with the least number left in a design.
  std::optional<PlaceRecord> first_place(const std::string& design);
  /// All places of a design, by number.
  std::vector<PlaceRecord> places_of(const std::string& design);
  /// The places of a revision in designs, in the order in which it got them.
  std::vector<PlaceRecord> places(const std::string& id);
  /// The place with the greatest number of a design whose revision is not `except`.
  std::optional<PlaceRecord> last_place(const std::string& design, const std::string& except);
  /// A row for each place in a design; with `unfiled`, for each revision in none.
  std::vector<ListedRevision> list(const RevisionFilter& filter, const RevisionPage& page);
  /// Designs that are on the list, also those without revisions.
  std::vector<DesignRecord> designs(const DesignFilter& filter, const DesignPage& page);
  /// Names of all designs that are on the list.
  std::vector<std::string> design_names();
  std::vector<std::string> children(const std::string& id, int limit);
  /// The recipe of a revision, even of a deleted one; empty where there is none.
  KeptRecipe recipe(const std::string& id);
  /// Has the catalogue keep these recipes by their line in the journal, all or none of them. Throws
  /// Error(`INDEX_FAILED`).
  void set_recipe_places(const std::vector<RecipePlace>& places);
  /// At least half the number of transactions of `snapshot`, at most all: an exact count takes
  /// longer.
  std::uint64_t count_lines();
  /// Ids that have a recipe, each with its parent's id.
  std::vector<std::pair<std::string, std::string>> recipes();
  /// Records of all revisions, by id.
  std::vector<RevisionRecord> revisions();
  /// Whether there is such a revision and it has a file.
  bool is_stored(const std::string& id);
  /// Revisions whose bytes are differences to those of `id`.
  std::vector<std::string> standing_on(const std::string& id);
  /// Whether a revision's bytes are differences to those of `id`.
  bool is_base(const std::string& id);
  std::uint32_t count_revisions();
  std::uint32_t count_designs();
  /// Bytes of the files of all revisions.
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
