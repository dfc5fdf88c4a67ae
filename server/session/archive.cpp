#include "server/session/archive.h"

#include <algorithm>
#include <iterator>

#include "server/session/session_error.h"

namespace remeshd {
namespace {

/// Members in the order in which a record keeps them: new ones come last.
constexpr double PhaseSeconds::*kSeconds[] = {
    &PhaseSeconds::setup, &PhaseSeconds::optimise, &PhaseSeconds::extract,
    &PhaseSeconds::difference, &PhaseSeconds::copy, &PhaseSeconds::verify, &PhaseSeconds::total};

std::vector<double> seconds_of(const PhaseSeconds& seconds) {
  std::vector<double> values;
  for (const auto member : kSeconds) values.push_back(seconds.*member);
  return values;
}
void set_seconds(PhaseSeconds& seconds, const std::vector<double>& values) {
  for (std::size_t i = 0; i < std::min(values.size(), std::size(kSeconds)); ++i)
    seconds.*kSeconds[i] = values[i];
}

}  // namespace

Archive::Archive(const Engine& engine, Store& store, std::uint64_t memory)
    : engine_(engine), store_(store), held_(memory, store.persistent(), engine.memory_blocks) {}

Reference Archive::resolve(const std::string& text) {
  return store_.read([&](Catalogue& catalogue) { return remeshd::resolve(catalogue, text); });
}

HeldRevisionPtr Archive::find(const std::string& id, const Run& run) {
  if (auto held = held_.find(id)) return held;
  if (!store_.persistent()) return nullptr;
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  if (!record) return nullptr;
  auto held = std::make_shared<HeldRevision>();
  held->record = *record;
  try {
    const HeldRevisionPtr parent = held_.find(record->parent);
    held->revision =
        engine_.revision_of(store_.get(id), parent ? &parent->revision : nullptr, run);
    Report& report = held->revision.report;
    report.revision = id;
    set_seconds(report.seconds, record->seconds);
  } catch (const Error& failure) {
    if (failure.info().kind == ErrorKind::Internal) {
      const std::scoped_lock lock(filing_);
      damaged_.insert(id);
    }
    throw;
  }
  held_.insert(held);
  return held;
}

HeldRevisionPtr Archive::get(const std::string& id, const Run& run) {
  auto held = find(id, run);
  if (!held) throw error::revision_not_found(id, "it was deleted a moment ago");
  return held;
}

void Archive::check_room() const {
  if (!store_.persistent() && held_.bytes() >= held_.budget())
    throw error::memory_full(held_.bytes(), held_.budget());
}

void Archive::drop_unfiled(const std::string& id) {
  const std::scoped_lock lock(filing_);
  if (!store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); })) held_.erase(id);
}

Filed Archive::file(const HeldRevisionPtr& revision, const std::string& design,
                    const HeadRule& rule) {
  const std::scoped_lock lock(filing_);
  const std::string& id = revision->record.id;
  Filed filed;
  filed.place = {.design = design, .number = 1, .id = id};
  const auto known = store_.read([&](Catalogue& catalogue) {
    if (const auto found = catalogue.design(design)) filed.place.number = found->next_number;
    return catalogue.revision(id);
  });
  filed.record = known.value_or(revision->record);
  const bool write = !known || damaged_.contains(id);
  if (write && store_.persistent()) put(*revision, filed);

  store_.commit([&](Catalogue& catalogue) {
    Transaction changes;
    if (write) changes.emplace_back(AddRevision{filed.record});
    const auto places = catalogue.places(id);
    const auto place = std::find_if(places.begin(), places.end(),
                                    [&](const PlaceRecord& p) { return p.design == design; });
    const bool is_new = place == places.end();
    if (is_new) {
      changes.emplace_back(AddPlace{design, filed.place.number, id});
    } else {
      filed.place.number = place->number;
    }

    const auto now = catalogue.design(design);
    const std::string head = now ? now->head : "";
    const bool expected = rule.expected.empty() ? is_new : head == rule.expected;
    const bool move = head.empty() || (rule.advance && expected);
    filed.head_moved = rule.advance && !rule.expected.empty() && !move && head != id;
    filed.head = move ? id : head;
    filed.head_number = filed.head == id ? filed.place.number : now->head_number;
    filed.place.head = filed.head == id;
    if (filed.head != head) changes.emplace_back(SetHead{design, id});
    return changes;
  });
  if (write) damaged_.erase(id);
  // It may have been dropped, unfiled or deleted, since the caller found it.
  if (!held_.contains(id)) held_.insert(revision);
  return filed;
}

void Archive::put(const HeldRevision& revision, Filed& filed) {
  filed.record.seconds = seconds_of(revision.revision.report.seconds);
  const StoredArrays arrays = engine_.image_of(revision.revision);
  const HeldRevisionPtr parent = held_.find(revision.record.parent);
  if (!parent) return store_.put(filed.record, filed.place, arrays);
  const StoredArrays like = engine_.image_of(parent->revision);
  const Packs::Base base{parent->record.id, &like};
  store_.put(filed.record, filed.place, arrays, &base);
}

Archive::Removed Archive::remove(const std::string& text, bool allow_head) {
  const std::scoped_lock lock(filing_);
  Removed removed;
  store_.commit([&](Catalogue& catalogue) {
    const Reference reference = remeshd::resolve(catalogue, text);
    removed.id = reference.id;
    Transaction changes;
    bool elsewhere = false;
    for (const PlaceRecord& place : catalogue.places(reference.id)) {
      if (!reference.design.empty() && place.design != reference.design) {
        elsewhere = true;
        continue;
      }
      if (place.head && !allow_head) throw error::head_protected(place.design, place.number);
      removed.places.push_back(place);
      changes.emplace_back(RemovePlace{place.design, place.number});
      if (!place.head) continue;
      const auto last = catalogue.last_place(place.design, reference.id);
      changes.emplace_back(SetHead{place.design, last ? last->id : ""});
    }
    removed.mesh_deleted = !elsewhere;
    if (!elsewhere) changes.emplace_back(RemoveRevision{reference.id});
    return changes;
  });
  if (removed.mesh_deleted) {
    held_.erase(removed.id);
    damaged_.erase(removed.id);
  }
  return removed;
}

}  // namespace remeshd
