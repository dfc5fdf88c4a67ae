#pragma once

#include <string>
#include <utility>
#include <vector>

#include "server/designs/design_table.h"
#include "server/designs/postgres.h"

namespace remeshd {

/// The table in PostgreSQL, 9.5 or newer: `remeshd_designs` and `remeshd_places`, created where
/// they are missing. A change of one design is one statement that compares the version and sets the
/// row.
class PostgresDesigns final : public DesignTable {
 public:
  /// `address`: as of Postgres. Connects when it is first used.
  explicit PostgresDesigns(std::string address);

  DesignState since(const std::string& tenant, const std::string& name,
                    std::uint64_t version) override;
  std::vector<std::pair<std::string, std::uint64_t>> versions(const std::string& tenant) override;
  std::vector<std::string> designs_of(const std::string& tenant, const std::string& id) override;
  bool change(const std::string& tenant, const std::vector<DesignChange>& changes) override;

 private:
  Postgres database_;
};

}  // namespace remeshd
