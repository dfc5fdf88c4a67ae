#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace remeshd {

/// A number of a design, and the revision that has it.
struct DesignRow {
  std::uint32_t number = 0;
  std::string id;      ///< of the revision; empty where the number was taken out
  std::string record;  ///< what is known of the revision without its mesh, as a journal line
};

/// A design as the table has it, or part of it.
struct DesignState {
  std::uint64_t version = 0;  ///< raised by one with every change; 0: there is no such design
  std::string head;           ///< id; empty where there is none
  std::uint32_t next_number = 1;
  std::int64_t changed_ns = 0;
  bool listed = true;
  std::vector<DesignRow> rows;  ///< those asked for, or those that change
};

/// A change of a design whose version is `expected`; 0: the design is new.
struct DesignChange {
  std::string name;
  std::uint64_t expected = 0;
  DesignState to;  ///< its version does not matter
};

/// The designs of all tenants, in a database that the replicas of a farm share. For any thread.
///
/// All functions throw Error(CATALOGUE_UNAVAILABLE) where the database cannot be reached, does not
/// answer in time, or fails. Whether a change was made is not known then.
class DesignTable {
 public:
  DesignTable() = default;
  virtual ~DesignTable() = default;
  DesignTable(const DesignTable&) = delete;
  DesignTable& operator=(const DesignTable&) = delete;

  /// The design, with the rows that changed after `version`; with all rows where its version is
  /// less than that (the table was lost and made again).
  virtual DesignState since(const std::string& tenant, const std::string& name,
                            std::uint64_t version) = 0;
  /// Names and versions of all designs.
  virtual std::vector<std::pair<std::string, std::uint64_t>> versions(
      const std::string& tenant) = 0;
  /// Designs that a revision stands in.
  virtual std::vector<std::string> designs_of(const std::string& tenant, const std::string& id) = 0;
  /// Makes all changes, or none: false where a design does not have the version expected. Once this
  /// returns, they survive a crash of the database.
  virtual bool change(const std::string& tenant, const std::vector<DesignChange>& changes) = 0;
};

}  // namespace remeshd
