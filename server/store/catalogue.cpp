#include "server/store/catalogue.h"

#include "engine/base/error.h"

namespace remeshd {
namespace {

constexpr const char* kSchema = R"(
CREATE TABLE IF NOT EXISTS meta(key TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS revisions(
  id TEXT PRIMARY KEY, parent TEXT NOT NULL, model_name TEXT NOT NULL, object TEXT NOT NULL,
  created_ns INTEGER NOT NULL, nodes INTEGER NOT NULL, tets INTEGER NOT NULL,
  bytes INTEGER NOT NULL) WITHOUT ROWID;
CREATE INDEX IF NOT EXISTS revisions_by_parent ON revisions(parent, id);
CREATE INDEX IF NOT EXISTS revisions_by_object ON revisions(object);
CREATE TABLE IF NOT EXISTS designs(
  name TEXT PRIMARY KEY, next_number INTEGER NOT NULL, head TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS places(
  entry INTEGER PRIMARY KEY AUTOINCREMENT, design TEXT NOT NULL, number INTEGER NOT NULL,
  id TEXT NOT NULL, UNIQUE(design, number), UNIQUE(design, id));
CREATE INDEX IF NOT EXISTS places_by_id ON places(id);
)";
constexpr std::int64_t kLayout = 1;

constexpr const char* kRevisionColumns =
    "r.id, r.parent, r.model_name, r.object, r.created_ns, r.nodes, r.tets, r.bytes";

RevisionRecord read_revision(const Sqlite::Statement& row, int first) {
  return {.id = row.text(first),
          .parent = row.text(first + 1),
          .model_name = row.text(first + 2),
          .object = row.text(first + 3),
          .created_ns = row.number(first + 4),
          .nodes = static_cast<std::uint32_t>(row.number(first + 5)),
          .tets = static_cast<std::uint32_t>(row.number(first + 6)),
          .bytes = static_cast<std::uint64_t>(row.number(first + 7))};
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

Catalogue::Catalogue(const std::string& file) : database_(file) {
  // The journal is what must survive; after a crash the index may be behind it, but not torn.
  database_.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  {
    auto check = database_.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok")
      throw error::internal("store", "the index is damaged: " + check.text(0));
  }
  database_.execute(kSchema);
  if (const std::int64_t layout = meta("layout"); layout != 0 && layout != kLayout)
    throw error::internal("store", "the index has layout " + std::to_string(layout));
  database_.prepare("INSERT OR IGNORE INTO meta VALUES('layout', ?)").bind(kLayout).run();
}

std::int64_t Catalogue::meta(const char* key) {
  auto row = database_.prepare("SELECT value FROM meta WHERE key = ?");
  row.bind(key);
  return row.step() ? row.number(0) : 0;
}
std::uint64_t Catalogue::journal_size() { return static_cast<std::uint64_t>(meta("journal_size")); }
std::uint32_t Catalogue::journal_mark() { return static_cast<std::uint32_t>(meta("journal_mark")); }

void Catalogue::apply(const Transaction& transaction, std::uint64_t journal_size,
                      std::uint32_t journal_mark) {
  database_.execute("BEGIN IMMEDIATE");
  try {
    for (const Operation& operation : transaction) apply_one(operation);
    database_.prepare("INSERT OR REPLACE INTO meta VALUES('journal_size', ?), ('journal_mark', ?)")
        .bind(static_cast<std::int64_t>(journal_size))
        .bind(std::int64_t{journal_mark})
        .run();
    database_.execute("COMMIT");
  } catch (...) {
    database_.execute("ROLLBACK");
    throw;
  }
}

void Catalogue::apply_one(const Operation& operation) {
  if (const auto* add = std::get_if<AddRevision>(&operation)) {
    const RevisionRecord& r = add->record;
    database_.prepare("INSERT OR REPLACE INTO revisions VALUES(?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(r.id)
        .bind(r.parent)
        .bind(r.model_name)
        .bind(r.object)
        .bind(r.created_ns)
        .bind(std::int64_t{r.nodes})
        .bind(std::int64_t{r.tets})
        .bind(static_cast<std::int64_t>(r.bytes))
        .run();
  } else if (const auto* place = std::get_if<AddPlace>(&operation)) {
    database_.prepare("INSERT OR IGNORE INTO designs VALUES(?, 1, '')").bind(place->design).run();
    database_.prepare("UPDATE designs SET next_number = max(next_number, ?) WHERE name = ?")
        .bind(std::int64_t{place->number} + 1)
        .bind(place->design)
        .run();
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
  } else {
    database_.prepare("DELETE FROM revisions WHERE id = ?")
        .bind(std::get<RemoveRevision>(operation).id)
        .run();
  }
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

bool Catalogue::has_object(const std::string& object) {
  auto row = database_.prepare("SELECT 1 FROM revisions WHERE object = ? LIMIT 1");
  row.bind(object);
  return row.step();
}

}  // namespace remeshd
