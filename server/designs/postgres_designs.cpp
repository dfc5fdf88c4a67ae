#include "server/designs/postgres_designs.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

namespace remeshd {
namespace {

using nlohmann::json;

// Two daemons that begin at the same time must not both make the tables.
constexpr const char* kSchema = R"(
BEGIN;
SET LOCAL client_min_messages = warning;
SELECT pg_advisory_xact_lock(82379201642);
CREATE TABLE IF NOT EXISTS remeshd_designs(
  tenant text NOT NULL, name text NOT NULL, version bigint NOT NULL, head text NOT NULL,
  next_number bigint NOT NULL, changed_ns bigint NOT NULL, listed boolean NOT NULL,
  PRIMARY KEY (tenant, name));
CREATE TABLE IF NOT EXISTS remeshd_places(
  tenant text NOT NULL, design text NOT NULL, number bigint NOT NULL, id text NOT NULL,
  record text NOT NULL, version bigint NOT NULL, PRIMARY KEY (tenant, design, number));
CREATE INDEX IF NOT EXISTS remeshd_places_by_version ON remeshd_places(tenant, design, version);
CREATE INDEX IF NOT EXISTS remeshd_places_by_id ON remeshd_places(tenant, id);
COMMIT)";

// Gives one row, of NULLs, where there is no such design.
constexpr const char* kSince = R"(
SELECT d.version, d.head, d.next_number, d.changed_ns, d.listed, p.number, p.id, p.record
FROM (SELECT 1) AS one
LEFT JOIN remeshd_designs d ON d.tenant = $1 AND d.name = $2
LEFT JOIN remeshd_places p ON p.tenant = d.tenant AND p.design = d.name
  AND p.version > (CASE WHEN d.version < $3::bigint THEN 0 ELSE $3::bigint END)
ORDER BY p.number)";

// Where the design is missing, only a change with version 0 inserts it: the table may have been
// lost, with changes of others.
constexpr const char* kChange = R"(
WITH moved AS (
  INSERT INTO remeshd_designs AS d
  SELECT $1, $2, $3::bigint + 1, $4, $5::bigint, $6::bigint, $7::boolean
  WHERE $3::bigint = 0 OR EXISTS (SELECT FROM remeshd_designs WHERE tenant = $1 AND name = $2)
  ON CONFLICT (tenant, name) DO UPDATE
  SET version = excluded.version, head = excluded.head, next_number = excluded.next_number,
      changed_ns = excluded.changed_ns, listed = excluded.listed
  WHERE d.version = $3::bigint
  RETURNING d.version),
placed AS (
  INSERT INTO remeshd_places AS p
  SELECT $1, $2, r.number, r.id, r.record, moved.version
  FROM moved, json_to_recordset($8::json) AS r(number bigint, id text, record text)
  ON CONFLICT (tenant, design, number) DO UPDATE
  SET id = excluded.id, record = excluded.record, version = excluded.version)
SELECT version FROM moved)";

template <typename Number>
Number number_in(const std::string& text) {
  Number number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

json to_json(const std::vector<DesignRow>& rows) {
  json list = json::array();
  for (const DesignRow& row : rows)
    list.push_back({{"number", row.number}, {"id", row.id}, {"record", row.record}});
  return list;
}

bool change_one(Postgres::Borrowed& database, const std::string& tenant,
                const DesignChange& change) {
  const DesignState& to = change.to;
  return !database
              .query(kChange, {tenant, change.name, std::to_string(change.expected), to.head,
                               std::to_string(to.next_number), std::to_string(to.changed_ns),
                               to.listed ? "true" : "false", to_json(to.rows).dump()})
              .empty();
}

}  // namespace

PostgresDesigns::PostgresDesigns(std::string address)
    : database_(std::move(address), {"SET client_encoding = 'UTF8'", kSchema}) {}

DesignState PostgresDesigns::since(const std::string& tenant, const std::string& name,
                                   std::uint64_t version) {
  DesignState state;
  for (Postgres::Row& row : database_.query(kSince, {tenant, name, std::to_string(version)})) {
    state.version = number_in<std::uint64_t>(row[0]);
    state.head = std::move(row[1]);
    state.next_number = std::max(1U, number_in<std::uint32_t>(row[2]));
    state.changed_ns = number_in<std::int64_t>(row[3]);
    state.listed = row[4] == "t";
    if (!row[5].empty())
      state.rows.push_back(
          {number_in<std::uint32_t>(row[5]), std::move(row[6]), std::move(row[7])});
  }
  return state;
}

std::vector<std::pair<std::string, std::uint64_t>> PostgresDesigns::versions(
    const std::string& tenant) {
  std::vector<std::pair<std::string, std::uint64_t>> all;
  for (Postgres::Row& row :
       database_.query("SELECT name, version FROM remeshd_designs WHERE tenant = $1", {tenant}))
    all.emplace_back(std::move(row[0]), number_in<std::uint64_t>(row[1]));
  return all;
}

std::vector<std::string> PostgresDesigns::designs_of(const std::string& tenant,
                                                     const std::string& id) {
  std::vector<std::string> designs;
  for (Postgres::Row& row : database_.query(
           "SELECT design FROM remeshd_places WHERE tenant = $1 AND id = $2 ORDER BY design",
           {tenant, id}))
    designs.push_back(std::move(row[0]));
  return designs;
}

bool PostgresDesigns::change(const std::string& tenant, const std::vector<DesignChange>& changes) {
  Postgres::Borrowed database(database_);
  if (changes.size() == 1) return change_one(database, tenant, changes.front());
  // Always in the same order, so that two changes cannot deadlock.
  std::vector<const DesignChange*> sorted;
  for (const DesignChange& each : changes) sorted.push_back(&each);
  std::ranges::sort(sorted, {}, &DesignChange::name);
  database.query("BEGIN");
  for (const DesignChange* each : sorted) {
    if (change_one(database, tenant, *each)) continue;
    database.query("ROLLBACK");
    return false;
  }
  database.query("COMMIT");
  return true;
}

}  // namespace remeshd
