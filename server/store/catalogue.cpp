#include "server/store/catalogue.h"

#include <cstring>
#include <set>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd {
namespace {

constexpr const char* kSchema = R"(
CREATE TABLE revisions(
  id TEXT PRIMARY KEY, parent TEXT NOT NULL, model_name TEXT NOT NULL,
  created_ns INTEGER NOT NULL, nodes INTEGER NOT NULL, tets INTEGER NOT NULL,
  bytes INTEGER NOT NULL, base TEXT NOT NULL, seconds TEXT NOT NULL) WITHOUT ROWID;
CREATE INDEX revisions_by_parent ON revisions(parent, id);
CREATE INDEX revisions_by_base ON revisions(base);
CREATE TABLE designs(
  name TEXT PRIMARY KEY, next_number INTEGER NOT NULL, head TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE places(
  entry INTEGER PRIMARY KEY AUTOINCREMENT, design TEXT NOT NULL, number INTEGER NOT NULL,
  id TEXT NOT NULL, UNIQUE(design, number), UNIQUE(design, id));
CREATE INDEX places_by_id ON places(id);
)";

constexpr const char* kRevisionColumns =
    "r.id, r.parent, r.model_name, r.created_ns, r.nodes, r.tets, r.bytes, r.base, r.seconds";

std::string_view bytes_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}
std::vector<double> numbers_in(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

RevisionRecord read_revision(const Sqlite::Statement& row, int first) {
  return {.id = row.text(first),
          .parent = row.text(first + 1),
          .model_name = row.text(first + 2),
          .created_ns = row.number(first + 3),
          .nodes = static_cast<std::uint32_t>(row.number(first + 4)),
          .tets = static_cast<std::uint32_t>(row.number(first + 5)),
          .bytes = static_cast<std::uint64_t>(row.number(first + 6)),
          .base = row.text(first + 7),
          .seconds = numbers_in(row.text(first + 8))};
}

constexpr const char* kSelectDesigns =
    "SELECT d.name, d.head, d.next_number, "
    "(SELECT count(*) FROM places p WHERE p.design = d.name), "
    "(SELECT p.number FROM places p WHERE p.design = d.name AND p.id = d.head) FROM designs d ";

DesignRecord read_design(const Sqlite::Statement& row) {
  return {.name = row.text(0),
          .head = row.text(1),
          .head_number = static_cast<std::uint32_t>(row.number(4)),
          .next_number = static_cast<std::uint32_t>(row.number(2)),
          .revisions = static_cast<std::uint32_t>(row.number(3))};
}

}  // namespace

Catalogue::Catalogue() : database_(":memory:") { database_.execute(kSchema); }

void Catalogue::apply(const Transaction& transaction, const std::function<void()>& confirm) {
  database_.execute("SAVEPOINT change");
  try {
    for (const Operation& operation : transaction) apply_one(operation);
    if (confirm) confirm();
  } catch (...) {
    // Out of memory, SQLite may have rolled back by itself.
    database_.try_execute("ROLLBACK TO change; RELEASE change");
    throw;
  }
  database_.execute("RELEASE change");
}

std::size_t Catalogue::apply_all(const std::vector<Transaction>& transactions) {
  std::size_t failed = 0;
  database_.execute("BEGIN");
  for (const Transaction& transaction : transactions) {
    try {
      apply(transaction);
    } catch (const Error&) {
      ++failed;
    }
  }
  database_.execute("COMMIT");
  return failed;
}

std::vector<Transaction> Catalogue::snapshot() {
  std::vector<Transaction> all{{StartAnew{}}};
  std::vector<DesignRecord> found = designs("", -1);
  for (const DesignRecord& design : found)
    all.push_back({AddDesign{design.name, design.next_number}});
  std::set<std::string> told;
  auto place =
      database_.prepare("SELECT p.design, p.number, p.id, " + std::string(kRevisionColumns) +
                        " FROM places p JOIN revisions r ON r.id = p.id ORDER BY p.entry");
  while (place.step()) {
    Transaction& next = all.emplace_back();
    if (told.insert(place.text(2)).second) next.emplace_back(AddRevision{read_revision(place, 3)});
    next.emplace_back(
        AddPlace{place.text(0), static_cast<std::uint32_t>(place.number(1)), place.text(2)});
  }
  auto unplaced = database_.prepare("SELECT " + std::string(kRevisionColumns) +
                                    " FROM revisions r WHERE r.id NOT IN (SELECT id FROM places)");
  while (unplaced.step()) all.push_back({AddRevision{read_revision(unplaced, 0)}});
  for (const DesignRecord& design : found)
    if (!design.head.empty()) all.push_back({SetHead{design.name, design.head}});
  return all;
}

void Catalogue::apply_one(const Operation& operation) {
  if (const auto* add = std::get_if<AddRevision>(&operation)) {
    const RevisionRecord& r = add->record;
    database_.prepare("INSERT OR REPLACE INTO revisions VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(r.id)
        .bind(r.parent)
        .bind(r.model_name)
        .bind(r.created_ns)
        .bind(std::int64_t{r.nodes})
        .bind(std::int64_t{r.tets})
        .bind(static_cast<std::int64_t>(r.bytes))
        .bind(r.base)
        .bind(bytes_of(r.seconds))
        .run();
  } else if (const auto* design = std::get_if<AddDesign>(&operation)) {
    grow_numbers(design->name, design->next_number);
  } else if (const auto* place = std::get_if<AddPlace>(&operation)) {
    grow_numbers(place->design, std::int64_t{place->number} + 1);
    if (at(place->design, place->number) == place->id) return;
    database_.prepare("INSERT INTO places(design, number, id) VALUES(?, ?, ?)")
        .bind(place->design)
        .bind(std::int64_t{place->number})
        .bind(place->id)
        .run();
  } else if (const auto* head = std::get_if<SetHead>(&operation)) {
    database_.prepare("UPDATE designs SET head = ? WHERE name = ?")
        .bind(head->id)
        .bind(head->design)
        .run();
  } else if (const auto* gone = std::get_if<RemovePlace>(&operation)) {
    database_.prepare("DELETE FROM places WHERE design = ? AND number = ?")
        .bind(gone->design)
        .bind(std::int64_t{gone->number})
        .run();
  } else if (const auto* removed = std::get_if<RemoveRevision>(&operation)) {
    database_.prepare("DELETE FROM revisions WHERE id = ?").bind(removed->id).run();
  } else {
    database_.execute("DELETE FROM revisions; DELETE FROM places; DELETE FROM designs;");
  }
}

void Catalogue::grow_numbers(const std::string& design, std::int64_t next_number) {
  database_
      .prepare(
          "INSERT INTO designs VALUES(?1, ?2, '') "
          "ON CONFLICT(name) DO UPDATE SET next_number = max(next_number, ?2)")
      .bind(design)
      .bind(next_number)
      .run();
}

std::optional<RevisionRecord> Catalogue::revision(const std::string& id) {
  auto row = database_.prepare("SELECT " + std::string(kRevisionColumns) +
                               " FROM revisions r WHERE r.id = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  return read_revision(row, 0);
}

std::vector<std::string> Catalogue::with_prefix(const std::string& prefix, int limit) {
  auto row =
      database_.prepare("SELECT id FROM revisions WHERE id >= ? AND id < ? ORDER BY id LIMIT ?");
  // `g` follows the last hexadecimal digit.
  row.bind(prefix).bind(prefix + "g").bind(std::int64_t{limit});
  std::vector<std::string> ids;
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

std::optional<std::string> Catalogue::at(const std::string& design, std::uint32_t number) {
  auto row = database_.prepare("SELECT id FROM places WHERE design = ? AND number = ?");
  row.bind(design).bind(std::int64_t{number});
  if (!row.step()) return std::nullopt;
  return row.text(0);
}

std::optional<DesignRecord> Catalogue::design(const std::string& name) {
  auto row = database_.prepare(std::string(kSelectDesigns) + "WHERE d.name = ?");
  row.bind(name);
  if (!row.step()) return std::nullopt;
  return read_design(row);
}

std::vector<DesignRecord> Catalogue::designs(const std::string& after, int limit) {
  auto row =
      database_.prepare(std::string(kSelectDesigns) + "WHERE d.name > ? ORDER BY d.name LIMIT ?");
  row.bind(after).bind(std::int64_t{limit});
  std::vector<DesignRecord> designs;
  while (row.step()) designs.push_back(read_design(row));
  return designs;
}

std::vector<PlaceRecord> Catalogue::places(const std::string& id) {
  auto row = database_.prepare(
      "SELECT p.design, p.number, p.id, d.head = p.id FROM places p "
      "JOIN designs d ON d.name = p.design WHERE p.id = ? ORDER BY p.entry");
  row.bind(id);
  std::vector<PlaceRecord> places;
  while (row.step())
    places.push_back(
        {row.text(0), static_cast<std::uint32_t>(row.number(1)), row.text(2), row.number(3) != 0});
  return places;
}

std::optional<PlaceRecord> Catalogue::last_place(const std::string& design,
                                                 const std::string& except) {
  auto row = database_.prepare(
      "SELECT design, number, id FROM places WHERE design = ? AND id <> ? "
      "ORDER BY number DESC LIMIT 1");
  row.bind(design).bind(except);
  if (!row.step()) return std::nullopt;
  return PlaceRecord{row.text(0), static_cast<std::uint32_t>(row.number(1)), row.text(2), false};
}

std::vector<ListedRevision> Catalogue::list(const std::string& design,
                                            const std::string& after_design,
                                            std::uint32_t after_number, int limit) {
  auto row = database_.prepare(
      "SELECT p.design, p.number, p.id, d.head = p.id, " + std::string(kRevisionColumns) +
      " FROM places p JOIN designs d ON d.name = p.design JOIN revisions r ON r.id = p.id "
      "WHERE (?1 = '' OR p.design = ?1) AND (p.design, p.number) > (?2, ?3) "
      "ORDER BY p.design, p.number LIMIT ?4");
  row.bind(design).bind(after_design).bind(std::int64_t{after_number}).bind(std::int64_t{limit});
  std::vector<ListedRevision> rows;
  while (row.step())
    rows.push_back(
        {{row.text(0), static_cast<std::uint32_t>(row.number(1)), row.text(2), row.number(3) != 0},
         read_revision(row, 4)});
  return rows;
}

std::vector<std::string> Catalogue::children(const std::string& id, int limit) {
  auto row = database_.prepare("SELECT id FROM revisions WHERE parent = ? ORDER BY id LIMIT ?");
  row.bind(id).bind(std::int64_t{limit});
  std::vector<std::string> ids;
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

bool Catalogue::is_base(const std::string& id) {
  auto row = database_.prepare("SELECT 1 FROM revisions WHERE base = ? LIMIT 1");
  row.bind(id);
  return row.step();
}

std::uint32_t Catalogue::count_revisions() {
  auto row = database_.prepare("SELECT count(*) FROM revisions");
  row.step();
  return static_cast<std::uint32_t>(row.number(0));
}
std::uint32_t Catalogue::count_designs() {
  auto row = database_.prepare("SELECT count(*) FROM designs");
  row.step();
  return static_cast<std::uint32_t>(row.number(0));
}

}  // namespace remeshd
