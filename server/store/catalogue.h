#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/store/records.h"
#include "server/store/sqlite.h"

namespace remeshd {

/// A row of a list of revisions.
struct ListedRevision {
  PlaceRecord place;
  RevisionRecord record;
};

/// What revisions and designs there are: an index, in memory, over the transactions applied to it.
class Catalogue {
 public:
  Catalogue();

  /// All or nothing; what is there already is left as it is, so that a transaction may be applied
  /// again. `confirm` is called once everything is applied; where it throws, nothing is.
  /// Throws Error(`IndexFailed`), also where a design's number is another revision's, before
  /// `confirm` is called.
  void apply(const Transaction& transaction, const std::function<void()>& confirm = {});
  /// Applies many, leaving out those that fail; how many did.
  std::size_t apply_all(const std::vector<Transaction>& transactions);
  /// Transactions that make an empty catalogue this one.
  std::vector<Transaction> snapshot();

  std::optional<RevisionRecord> revision(const std::string& id);
  /// Ids that begin with `prefix` (hexadecimal digits), at most `limit`, sorted.
  std::vector<std::string> with_prefix(const std::string& prefix, int limit);
  std::optional<std::string> at(const std::string& design, std::uint32_t number);
  std::optional<DesignRecord> design(const std::string& name);
  /// Where a revision stands, in the order in which it got there.
  std::vector<PlaceRecord> places(const std::string& id);
  /// The greatest number of a design that is not that of `except`.
  std::optional<PlaceRecord> last_place(const std::string& design, const std::string& except);
  /// By design and number, after the given ones; of one design, or of all if `design` is empty.
  std::vector<ListedRevision> list(const std::string& design, const std::string& after_design,
                                   std::uint32_t after_number, int limit);
  std::vector<DesignRecord> designs(const std::string& after, int limit);
  std::vector<std::string> children(const std::string& id, int limit);
  /// Whether a revision's bytes are differences to those of `id`.
  bool is_base(const std::string& id);
  std::uint32_t count_revisions();
  std::uint32_t count_designs();

 private:
  void apply_one(const Operation& operation);
  void grow_numbers(const std::string& design, std::int64_t next_number);

  Sqlite database_;
};

}  // namespace remeshd
