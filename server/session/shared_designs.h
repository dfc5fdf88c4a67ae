#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/designs/design_table.h"
#include "server/store/store.h"

namespace remeshd {

/// A tenant's designs in a table that the replicas of a farm share. The store's catalogue has a
/// copy of what was looked at, which is brought up to date before it is read, and changes only
/// after the table has.
///
/// A design that the table does not have is entered as the catalogue has it: so a store from before
/// there was a table keeps its designs, and a table that was lost is filled again. Where both have
/// a design, the table's counts.
/// For any thread. All functions throw Error(CATALOGUE_UNAVAILABLE).
class SharedDesigns {
 public:
  /// `store` must outlive it.
  SharedDesigns(std::shared_ptr<DesignTable> table, std::string tenant, Store& store);

  /// Bring the catalogue up to date: with one design; with those that a revision stands in; with
  /// all.
  void refresh(const std::string& design);
  void refresh_of(const std::string& id);
  void refresh_all();

  using Make = std::function<Transaction(Catalogue&)>;
  /// Commits a transaction to the store; returns whether it is durable, as Store::commit.
  using Commit = std::function<bool(const Transaction&)>;
  /// Changes the table, then has the store do so. A transaction that was made from a copy which is
  /// out of date is made again of a newer one. Throws also what `make` and `commit` throw.
  bool commit(const Make& make, const Commit& commit);

 private:
  void refresh_locked(const std::string& design);
  bool upload(const std::string& design);
  [[nodiscard]] std::uint64_t version_of(const std::string& design) const;
  std::vector<DesignChange> changes_of(Catalogue& catalogue, const Transaction& transaction) const;

  const std::shared_ptr<DesignTable> table_;
  const std::string tenant_;
  Store& store_;
  std::mutex mutex_;                               ///< guards what follows, and the copy
  std::map<std::string, std::uint64_t> versions_;  ///< of the copies, by design
};

}  // namespace remeshd
