#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace remeshd {

/// A number of a design in the table.
struct DesignRow {
  std::uint32_t number = 0;
  std::string id;      ///< of the revision; empty where the number was taken out
  std::string record;  ///< what is known of the revision without reading it: a line of a journal
};

/// A design as the table has it, or part of it.
struct DesignState {
  std::uint64_t version = 0;  ///< one more with every change; 0: there is none
  std::string head;           ///< id; empty where there is none
  std::uint32_t next_number = 1;
  std::int64_t changed_ns = 0;
  bool listed = true;
  std::vector<DesignRow> rows;  ///< those asked for, or those that change
};

/// A change of a design that has the version `expected`, or with 0 is new.
struct DesignChange {
  std::string name;
  std::uint64_t expected = 0;
  DesignState to;  ///< its version does not matter
};

/// The designs of all tenants, in a database that the replicas of a farm share. For any thread.
///
/// All functions throw Error(CATALOGUE_UNAVAILABLE) where it cannot be reached, does not answer in
/// time, or fails. Whether a change was made is not known then.
class DesignTable {
 public:
  DesignTable() = default;
  virtual ~DesignTable() = default;
  DesignTable(const DesignTable&) = delete;
  DesignTable& operator=(const DesignTable&) = delete;

  /// The design, with the rows that changed after `version` where it has another one; all of them
  /// where that version is not one of its past.
  virtual DesignState since(const std::string& tenant, const std::string& name,
                            std::uint64_t version) = 0;
  /// Names and versions of all designs.
  virtual std::vector<std::pair<std::string, std::uint64_t>> versions(
      const std::string& tenant) = 0;
  /// Designs that a revision stands in.
  virtual std::vector<std::string> designs_of(const std::string& tenant, const std::string& id) = 0;
  /// Makes all changes, or none: false where a design has not the version expected. Returns when
  /// they outlast a crash of the database.
  virtual bool change(const std::string& tenant, const std::vector<DesignChange>& changes) = 0;
};

}  // namespace remeshd
