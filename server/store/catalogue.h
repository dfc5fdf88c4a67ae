#pragma once

#include <cstdint>
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

/// What revisions and designs there are: an index over the transactions applied to it, which can be
/// made again from them.
class Catalogue {
 public:
  /// Opens or makes the database `file` (":memory:" for none). Throws Error(Internal) on one that
  /// is damaged or of another layout.
  explicit Catalogue(const std::string& file);

  /// All or nothing. `journal_size` and `journal_mark` say up to where in the journal the index
  /// goes then.
  void apply(const Transaction& transaction, std::uint64_t journal_size,
             std::uint32_t journal_mark);
  [[nodiscard]] std::uint64_t journal_size();
  [[nodiscard]] std::uint32_t journal_mark();

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
  std::uint32_t count_revisions();
  std::uint32_t count_designs();
  bool has_object(const std::string& object);

 private:
  void apply_one(const Operation& operation);
  std::int64_t meta(const char* key);

  Sqlite database_;
};

}  // namespace remeshd
