#include "server/session/shared_designs.h"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "server/designs/design_error.h"
#include "server/session/shared_record.h"

namespace remeshd {
namespace {

// Attempts at a change while others change the same design, after which it fails.
constexpr int kMostTries = 1000;

RevisionRecord record_in(const DesignRow& row) {
  auto added = revision_in(row.record);
  if (!added || added->record.id != row.id)
    throw error::catalogue_unavailable("what it tells of the revision " + row.id +
                                       " cannot be read: is it of a newer version?");
  return std::move(added->record);
}

/// The design that an operation changes; null for one that changes none.
const std::string* design_of(const Operation& operation) {
  if (const auto* place = std::get_if<AddPlace>(&operation)) return &place->design;
  if (const auto* gone = std::get_if<RemovePlace>(&operation)) return &gone->design;
  if (const auto* head = std::get_if<SetHead>(&operation)) return &head->design;
  if (const auto* design = std::get_if<AddDesign>(&operation)) return &design->name;
  return nullptr;
}

/// The design as the catalogue has it, be it on the list or not, without rows.
DesignState state_of(Catalogue& catalogue, const std::string& name) {
  DesignState state{.next_number = catalogue.next_number(name)};
  const auto design = catalogue.design(name);
  state.listed = design.has_value();
  if (design) {
    state.head = design->head;
    state.changed_ns = design->changed_ns;
  }
  return state;
}

std::vector<DesignRow> rows_of(Catalogue& catalogue, const std::string& name) {
  std::vector<DesignRow> rows;
  for (const PlaceRecord& place : catalogue.places_of(name))
    if (const auto record = catalogue.revision(place.id))
      rows.push_back({place.number, place.id, line_of(*record, "")});
  return rows;
}

/// The transaction that makes the catalogue's copy of a design the same as `state`. `all`: the
/// state has all rows, so places without a row go.
Transaction differences(Catalogue& catalogue, const std::string& name, const DesignState& state,
                        bool all) {
  Transaction changes{AddDesign{.name = name,
                                .next_number = state.next_number,
                                .changed_ns = state.changed_ns,
                                .listed = state.listed}};
  std::set<std::uint32_t> told;
  Transaction added;
  for (const DesignRow& row : state.rows) {
    const auto there = catalogue.at(name, row.number);
    if (!row.id.empty()) told.insert(row.number);
    if (there == row.id) continue;
    if (there) changes.emplace_back(RemovePlace{name, row.number});
    if (row.id.empty()) continue;
    if (!catalogue.revision(row.id)) added.emplace_back(AddRevision{record_in(row)});
    added.emplace_back(AddPlace{name, row.number, row.id});
  }
  if (all)
    for (const PlaceRecord& place : catalogue.places_of(name))
      if (!told.contains(place.number)) changes.emplace_back(RemovePlace{name, place.number});
  changes.insert(changes.end(), added.begin(), added.end());
  changes.emplace_back(SetHead{name, state.head});
  return changes;
}

}  // namespace

SharedDesigns::SharedDesigns(std::shared_ptr<DesignTable> table, std::string tenant, Store& store)
    : table_(std::move(table)), tenant_(std::move(tenant)), store_(store) {}

void SharedDesigns::refresh(const std::string& design) {
  const std::scoped_lock lock(mutex_);
  refresh_locked(design);
}

void SharedDesigns::refresh_of(const std::string& id) {
  const std::vector<std::string> designs = table_->designs_of(tenant_, id);
  const std::scoped_lock lock(mutex_);
  for (const std::string& design : designs) refresh_locked(design);
  // Designs of a store from before there was a table.
  for (const PlaceRecord& place :
       store_.read([&](Catalogue& catalogue) { return catalogue.places(id); }))
    if (std::ranges::find(designs, place.design) == designs.end()) refresh_locked(place.design);
}

void SharedDesigns::refresh_all() {
  const auto versions = table_->versions(tenant_);
  const std::scoped_lock lock(mutex_);
  std::set<std::string> known;
  for (const auto& [design, version] : versions) {
    known.insert(design);
    if (const auto copy = versions_.find(design);
        copy == versions_.end() || copy->second != version)
      refresh_locked(design);
  }
  for (const std::string& design :
       store_.read([](Catalogue& catalogue) { return catalogue.design_names(); }))
    if (!known.contains(design)) refresh_locked(design);
}

void SharedDesigns::refresh_locked(const std::string& design) {
  for (int tries = 0; tries < kMostTries; ++tries) {
    const std::uint64_t before = version_of(design);
    const DesignState state = table_->since(tenant_, design, before);
    if (state.version == 0) {
      versions_.erase(design);
      if (upload(design)) return;
      continue;
    }
    if (state.version == before) return;
    const bool all = before == 0 || state.version < before;
    store_.commit([&](Catalogue& catalogue) { return differences(catalogue, design, state, all); },
                  Store::OnFullDisk::GoOn);
    versions_[design] = state.version;
    return;
  }
  throw error::catalogue_unavailable("others change the design `" + design + "` all the time");
}

/// Enters the catalogue's copy of a design in the table, if it has one; false where another daemon
/// was first.
bool SharedDesigns::upload(const std::string& design) {
  DesignState state;
  store_.read([&](Catalogue& catalogue) {
    state = state_of(catalogue, design);
    state.rows = rows_of(catalogue, design);
  });
  if (!state.listed) return true;
  if (!table_->change(tenant_, {{.name = design, .to = state}})) return false;
  versions_[design] = 1;
  return true;
}

std::uint64_t SharedDesigns::version_of(const std::string& design) const {
  const auto found = versions_.find(design);
  return found == versions_.end() ? 0 : found->second;
}

std::vector<DesignChange> SharedDesigns::changes_of(Catalogue& catalogue,
                                                    const Transaction& transaction) const {
  std::map<std::string, DesignState> states;
  std::map<std::string, RevisionRecord> added;
  for (const Operation& operation : transaction) {
    if (const auto* revision = std::get_if<AddRevision>(&operation))
      added[revision->record.id] = revision->record;
    const std::string* const name = design_of(operation);
    if (name == nullptr) continue;
    const auto [found, is_first] = states.try_emplace(*name);
    DesignState& state = found->second;
    if (is_first) state = state_of(catalogue, *name);
    if (const auto* place = std::get_if<AddPlace>(&operation)) {
      const auto record =
          added.contains(place->id) ? added[place->id] : catalogue.revision(place->id).value();
      state.rows.push_back({place->number, place->id, line_of(record, "")});
      state.next_number = std::max(state.next_number, place->number + 1);
      state.listed = true;
    } else if (const auto* gone = std::get_if<RemovePlace>(&operation)) {
      state.rows.push_back({.number = gone->number});
    } else if (const auto* head = std::get_if<SetHead>(&operation)) {
      state.head = head->id;
    } else {
      const auto& design = std::get<AddDesign>(operation);
      state.next_number = std::max(state.next_number, design.next_number);
      state.changed_ns = std::max(state.changed_ns, design.changed_ns);
      state.listed = design.listed;
    }
  }
  std::vector<DesignChange> changes;
  for (auto& [name, state] : states)
    changes.push_back({.name = name, .expected = version_of(name), .to = std::move(state)});
  return changes;
}

bool SharedDesigns::commit(const Make& make, const Commit& apply) {
  const std::scoped_lock lock(mutex_);
  std::set<std::string> looked_at;  // in the table, which may have none of them
  for (int tries = 0; tries < kMostTries; ++tries) {
    Transaction transaction;
    std::vector<DesignChange> changes;
    store_.read([&](Catalogue& catalogue) {
      transaction = make(catalogue);
      changes = changes_of(catalogue, transaction);
    });
    const auto is_known = [&](const DesignChange& change) {
      return versions_.contains(change.name) || looked_at.contains(change.name);
    };
    if (std::ranges::all_of(changes, is_known) &&
        (changes.empty() || table_->change(tenant_, changes))) {
      const bool durable = apply(transaction);
      for (const DesignChange& change : changes) versions_[change.name] = change.expected + 1;
      return durable;
    }
    for (const DesignChange& change : changes) {
      refresh_locked(change.name);
      looked_at.insert(change.name);
    }
  }
  throw error::catalogue_unavailable("others change the same designs all the time");
}

}  // namespace remeshd
