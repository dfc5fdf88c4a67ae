#include "server/store/catalogue.h"

#include <algorithm>
#include <set>

#include "engine/base/error.h"
#include "server/store/catalogue_rows.h"

namespace remeshd {
namespace {

constexpr const char* kSchema = R"(
CREATE TABLE revisions(
  id TEXT PRIMARY KEY, parent TEXT NOT NULL, root TEXT NOT NULL, model_name TEXT NOT NULL,
  model TEXT NOT NULL, algorithm_version INTEGER NOT NULL, created_ns INTEGER NOT NULL,
  nodes INTEGER NOT NULL, tets INTEGER NOT NULL, bytes INTEGER NOT NULL,
  base TEXT NOT NULL, seconds TEXT NOT NULL, pinned INTEGER NOT NULL,
  mid_nodes INTEGER NOT NULL) WITHOUT ROWID;
CREATE INDEX revisions_by_parent ON revisions(parent, id);
CREATE INDEX revisions_by_base ON revisions(base);
CREATE TABLE recipes(
  id TEXT PRIMARY KEY, parent TEXT NOT NULL, recipe TEXT NOT NULL, line_start INTEGER NOT NULL,
  line_length INTEGER NOT NULL) WITHOUT ROWID;
CREATE INDEX recipes_by_parent ON recipes(parent);
CREATE TABLE designs(
  name TEXT PRIMARY KEY, next_number INTEGER NOT NULL, head TEXT NOT NULL,
  changed_ns INTEGER NOT NULL, listed INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE places(
  entry INTEGER PRIMARY KEY AUTOINCREMENT, design TEXT NOT NULL, number INTEGER NOT NULL,
  id TEXT NOT NULL, UNIQUE(design, number), UNIQUE(design, id));
CREATE INDEX places_by_id ON places(id);
)";

}  // namespace

Catalogue::Catalogue() : database_(":memory:") { database_.execute(kSchema); }

void Catalogue::apply(const Transaction& transaction) { run(transaction, true); }

void Catalogue::check(const Transaction& transaction) { run(transaction, false); }

void Catalogue::run(const Transaction& transaction, bool keep) {
  database_.execute("SAVEPOINT change");
  try {
    for (const Operation& operation : transaction) apply_one(operation);
  } catch (...) {
    // Out of memory, SQLite may have rolled back by itself.
    database_.try_execute("ROLLBACK TO change; RELEASE change");
    throw;
  }
  database_.execute(keep ? "RELEASE change" : "ROLLBACK TO change; RELEASE change");
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
  std::vector<SetHead> heads;
  auto design =
      database_.prepare("SELECT name, next_number, changed_ns, listed, head FROM designs");
  while (design.step()) {
    all.push_back({AddDesign{.name = design.text(0),
                             .next_number = static_cast<std::uint32_t>(design.number(1)),
                             .changed_ns = design.number(2),
                             .listed = design.number(3) != 0}});
    if (!design.text(4).empty()) heads.push_back({design.text(0), design.text(4)});
  }
  std::set<std::string> told;
  auto place = database_.prepare("SELECT p.design, p.number, p.id, " + kRevisionColumns +
                                 " FROM places p JOIN revisions r ON r.id = p.id ORDER BY p.entry");
  while (place.step()) {
    Transaction& next = all.emplace_back();
    if (told.insert(place.text(2)).second)
      next.emplace_back(AddRevision{read_revision(place, 3), recipe(place.text(2))});
    next.emplace_back(
        AddPlace{place.text(0), static_cast<std::uint32_t>(place.number(1)), place.text(2)});
  }
  auto unplaced = database_.prepare("SELECT " + kRevisionColumns +
                                    " FROM revisions r WHERE r.id NOT IN (SELECT id FROM places)");
  while (unplaced.step())
    all.push_back({AddRevision{read_revision(unplaced, 0), recipe(unplaced.text(0))}});
  auto kept = database_.prepare("SELECT recipe, line_start, line_length, id, parent FROM recipes");
  while (kept.step())
    if (const std::string id = id_of(kept.text(3)); !revision(id))
      all.push_back({KeepRecipe{id, id_of(kept.text(4)), read_recipe(kept)}});
  for (const SetHead& head : heads) all.push_back({head});
  return all;
}

void Catalogue::apply_one(const Operation& operation) {
  if (const auto* add = std::get_if<AddRevision>(&operation)) {
    const RevisionRecord& r = add->record;
    database_
        .prepare(
            "INSERT OR REPLACE INTO revisions VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(r.id)
        .bind(r.parent)
        .bind(r.root)
        .bind(r.model_name)
        .bind(r.model)
        .bind(std::int64_t{r.algorithm_version})
        .bind(r.created_ns)
        .bind(std::int64_t{r.nodes})
        .bind(std::int64_t{r.tets})
        .bind(static_cast<std::int64_t>(r.bytes))
        .bind(r.base)
        .bind(bytes_of(r.seconds))
        .bind(std::int64_t{r.pinned})
        .bind(std::int64_t{r.mid_nodes})
        .run();
    if (!add->recipe.empty()) keep_recipe({r.id, r.parent, add->recipe});
  } else if (const auto* design = std::get_if<AddDesign>(&operation)) {
    enter_design(*design);
  } else if (const auto* place = std::get_if<AddPlace>(&operation)) {
    enter_design({.name = place->design, .next_number = place->number + 1});
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
    drop_recipe(removed->id);
  } else if (const auto* recipe = std::get_if<KeepRecipe>(&operation)) {
    keep_recipe(*recipe);
  } else if (const auto* drop = std::get_if<DropMesh>(&operation)) {
    database_.prepare("UPDATE revisions SET bytes = 0, base = '' WHERE id = ?")
        .bind(drop->id)
        .run();
  } else if (const auto* pin = std::get_if<SetPin>(&operation)) {
    database_.prepare("UPDATE revisions SET pinned = ? WHERE id = ?")
        .bind(std::int64_t{pin->pinned})
        .bind(pin->id)
        .run();
  } else {
    database_.execute(
        "DELETE FROM revisions; DELETE FROM places; DELETE FROM designs; DELETE FROM recipes;");
  }
}

void Catalogue::keep_recipe(const KeepRecipe& keep) {
  const JournalPlace line = keep.recipe.place.value_or(JournalPlace{});
  database_.prepare("INSERT OR REPLACE INTO recipes VALUES(?, ?, ?, ?, ?)")
      .bind(key_of(keep.id))
      .bind(key_of(keep.parent))
      .bind(keep.recipe.bytes)
      .bind(static_cast<std::int64_t>(line.start))
      .bind(static_cast<std::int64_t>(line.length))
      .run();
}

void Catalogue::set_recipe_places(const std::vector<RecipePlace>& places) {
  database_.execute("SAVEPOINT places");
  try {
    for (const auto& [id, line] : places)
      database_
          .prepare("UPDATE recipes SET recipe = '', line_start = ?, line_length = ? WHERE id = ?")
          .bind(static_cast<std::int64_t>(line.start))
          .bind(static_cast<std::int64_t>(line.length))
          .bind(key_of(id))
          .run();
  } catch (...) {
    database_.try_execute("ROLLBACK TO places; RELEASE places");
    throw;
  }
  database_.execute("RELEASE places");
}

void Catalogue::drop_recipe(std::string id) {
  // A recipe stays while its revision, or a child's record or recipe, is there: children are remade
  // from it. Once it goes, its parent's may be free to go too.
  while (!id.empty() && !revision(id)) {
    auto child = database_.prepare(
        "SELECT 1 FROM revisions WHERE parent = ?1 "
        "UNION ALL SELECT 1 FROM recipes WHERE parent = ?2 LIMIT 1");
    const std::string key = key_of(id);
    child.bind(id).bind(key);
    if (child.step()) return;
    auto row = database_.prepare("SELECT parent FROM recipes WHERE id = ?");
    row.bind(key);
    id = row.step() ? id_of(row.text(0)) : "";
    database_.prepare("DELETE FROM recipes WHERE id = ?").bind(key).run();
  }
}

void Catalogue::enter_design(const AddDesign& design) {
  database_
      .prepare(
          "INSERT INTO designs VALUES(?1, ?2, '', ?3, ?4) ON CONFLICT(name) DO UPDATE SET "
          "next_number = max(next_number, ?2), changed_ns = max(changed_ns, ?3), listed = ?4")
      .bind(design.name)
      .bind(std::int64_t{design.next_number})
      .bind(design.changed_ns)
      .bind(std::int64_t{design.listed})
      .run();
}

std::optional<RevisionRecord> Catalogue::revision(const std::string& id) {
  auto row = database_.prepare("SELECT " + kRevisionColumns + " FROM revisions r WHERE r.id = ?");
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
  auto row = database_.prepare(kSelectDesigns + "WHERE name = ?");
  row.bind(name);
  if (!row.step()) return std::nullopt;
  return read_design(row);
}

std::uint32_t Catalogue::next_number(const std::string& design) {
  auto row = database_.prepare("SELECT next_number FROM designs WHERE name = ?");
  row.bind(design);
  return row.step() ? static_cast<std::uint32_t>(row.number(0)) : 1;
}

std::vector<PlaceRecord> Catalogue::places_of(const std::string& design) {
  auto row = database_.prepare(
      "SELECT p.number, p.id, d.head = p.id FROM places p JOIN designs d ON d.name = p.design "
      "WHERE p.design = ? ORDER BY p.number");
  row.bind(design);
  std::vector<PlaceRecord> places;
  while (row.step())
    places.push_back(
        {design, static_cast<std::uint32_t>(row.number(0)), row.text(1), row.number(2) != 0});
  return places;
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

std::optional<PlaceRecord> Catalogue::first_place(const std::string& design) {
  auto row =
      database_.prepare("SELECT number, id FROM places WHERE design = ? ORDER BY number LIMIT 1");
  row.bind(design);
  if (!row.step()) return std::nullopt;
  return PlaceRecord{design, static_cast<std::uint32_t>(row.number(0)), row.text(1), false};
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

std::vector<std::string> Catalogue::children(const std::string& id, int limit) {
  auto row = database_.prepare("SELECT id FROM revisions WHERE parent = ? ORDER BY id LIMIT ?");
  row.bind(id).bind(std::int64_t{limit});
  std::vector<std::string> ids;
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

std::vector<std::string> Catalogue::design_names() {
  auto row = database_.prepare("SELECT name FROM designs WHERE listed ORDER BY name");
  std::vector<std::string> names;
  while (row.step()) names.push_back(row.text(0));
  return names;
}

KeptRecipe Catalogue::recipe(const std::string& id) {
  auto row = database_.prepare("SELECT recipe, line_start, line_length FROM recipes WHERE id = ?");
  row.bind(key_of(id));
  return row.step() ? read_recipe(row) : KeptRecipe{};
}

std::uint64_t Catalogue::count_lines() {
  auto row = database_.prepare(
      "SELECT (SELECT count(*) + count(nullif(head, '')) FROM designs),"
      " (SELECT count(*) FROM places), (SELECT count(DISTINCT id) FROM places),"
      " (SELECT count(*) FROM revisions), (SELECT count(*) FROM recipes)");
  row.step();
  const std::int64_t designs = row.number(0), places = row.number(1), placed = row.number(2),
                     revisions = row.number(3), recipes = row.number(4);
  // Recipes without a revision are at least these, for a revision may have none.
  const std::int64_t alone = std::max<std::int64_t>(recipes - revisions, 0);
  return static_cast<std::uint64_t>(1 + designs + places + (revisions - placed) + alone);
}

std::vector<std::pair<std::string, std::string>> Catalogue::recipes() {
  auto row = database_.prepare("SELECT id, parent FROM recipes ORDER BY id");
  std::vector<std::pair<std::string, std::string>> all;
  while (row.step()) all.emplace_back(id_of(row.text(0)), id_of(row.text(1)));
  return all;
}

std::vector<RevisionRecord> Catalogue::revisions() {
  auto row = database_.prepare("SELECT " + kRevisionColumns + " FROM revisions r ORDER BY r.id");
  std::vector<RevisionRecord> all;
  while (row.step()) all.push_back(read_revision(row, 0));
  return all;
}

bool Catalogue::is_stored(const std::string& id) {
  const auto record = revision(id);
  return record && record->bytes > 0;
}

std::vector<std::string> Catalogue::standing_on(const std::string& id) {
  auto row = database_.prepare("SELECT id FROM revisions WHERE base = ? ORDER BY id");
  row.bind(id);
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
std::uint64_t Catalogue::count_bytes() {
  auto row = database_.prepare("SELECT coalesce(sum(bytes), 0) FROM revisions");
  row.step();
  return static_cast<std::uint64_t>(row.number(0));
}
std::uint32_t Catalogue::count_designs() {
  auto row = database_.prepare("SELECT count(*) FROM designs WHERE listed");
  row.step();
  return static_cast<std::uint32_t>(row.number(0));
}

}  // namespace remeshd
