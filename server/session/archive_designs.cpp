#include <algorithm>

#include "server/session/archive.h"
#include "server/session/changed_now.h"
#include "server/session/session_error.h"

// What the archive does with designs, in its store alone or shared with a farm.
namespace remeshd {
namespace {

DesignRecord listed_design(Catalogue& catalogue, const std::string& name) {
  auto found = catalogue.design(name);
  if (!found) throw error::design_not_found(name);
  return *std::move(found);
}

void check_expected(const DesignRecord& design, const std::string& expected) {
  if (!expected.empty() && design.head != expected)
    throw error::head_conflict(design.name, expected, design.head);
}

/// That nothing says which of the designs that have a revision is meant.
Error several_designs(const std::string& id, const std::vector<PlaceRecord>& places) {
  constexpr std::size_t kTold = 3;
  std::string hint = id.substr(0, 12) + " stands in ";
  for (std::size_t i = 0; i < std::min(places.size(), kTold); ++i)
    hint += (i == 0 ? "`" : ", `") + places[i].design + "`";
  if (places.size() > kTold) hint += " and " + std::to_string(places.size() - kTold) + " more";
  const PlaceRecord& first = places.front();
  return error::field_missing("design", hint + ": name one, or give " + first.design + "@" +
                                            std::to_string(first.number) + " in place of the id");
}

}  // namespace

void Archive::look_at_design(const std::string& design) {
  if (design.empty()) return;
  homes_.check(design);
  if (designs_) designs_->refresh(design);
}

void Archive::look_at_named(const std::string& text) {
  if (const auto design = design_named_by(text)) look_at_design(*design);
}

void Archive::look_at_places(const std::string& id) {
  if (designs_) designs_->refresh_of(id);
}

void Archive::look_at_designs() {
  if (designs_) designs_->refresh_all();
}

std::string Archive::design_of(const std::string& id, const std::string& last) {
  look_at_places(id);
  const auto places = store_.read([&](Catalogue& catalogue) { return catalogue.places(id); });
  if (places.empty()) return "";
  if (places.size() == 1) return places.front().design;
  if (std::ranges::find(places, last, &PlaceRecord::design) == places.end())
    throw several_designs(id, places);
  return last;
}

std::string Archive::head_of(const std::string& design) {
  look_at_design(design);
  const auto found = store_.read([&](Catalogue& catalogue) { return catalogue.design(design); });
  return found ? found->head : "";
}

bool Archive::commit_designs(const SharedDesigns::Make& make, Store::OnFullDisk on_full_disk) {
  if (!designs_) {
    const std::scoped_lock lock(filing_);
    return store_.commit(make, on_full_disk);
  }
  return designs_->commit(make, [&](const Transaction& transaction) {
    const std::scoped_lock lock(filing_);
    return store_.commit([&](Catalogue&) { return transaction; }, on_full_disk);
  });
}

/// Files the revision in no design first, so that it is kept whatever becomes of its place, and
/// publishes it, so that replicas that find it in the design find it in the tier.
Filed Archive::file_with_others(const HeldRevisionPtr& revision, const std::string& design,
                                const HeadRule& rule, const std::vector<WarningCode>& fail_on) {
  try {
    check_filing(revision->record, design, rule, fail_on);
  } catch (const Error& failure) {
    if (failure.info().kind == ErrorKind::Unavailable) file(revision, "", {});
    throw;
  }
  Filed filed = file(revision, "", {}, fail_on);
  publish(revision->record.id);
  const bool durable = filed.durable;
  const RevisionRecord record = filed.record;
  const auto make = [&](Catalogue& catalogue) {
    Filing filing = plan_filing(catalogue, record, design, rule, fail_on);
    filed = std::move(filing.filed);
    return filing.changes;
  };
  const bool entered = commit_designs(make, Store::OnFullDisk::GoOn);
  filed.durable = durable && entered;
  return filed;
}

Archive::HeadSet Archive::set_head(const std::string& text, const std::string& design,
                                   const std::string& expected) {
  look_at_named(text);
  look_at_design(design);
  HeadSet set;
  const auto move = [&](Catalogue& catalogue) {
    const Reference reference = remeshd::resolve(catalogue, text);
    const std::string& name = design.empty() ? reference.design : design;
    if (name.empty())
      throw error::field_missing("design", "an id names no design; design@number does");
    const DesignRecord now = listed_design(catalogue, name);
    const auto places = catalogue.places(reference.id);
    if (std::ranges::find(places, name, &PlaceRecord::design) == places.end())
      throw error::revision_not_found(text, "the design `" + name + "` does not have it");
    check_expected(now, expected);
    set.previous = now.head;
    set.design.name = name;
    if (now.head == reference.id) return Transaction{};
    return Transaction{SetHead{name, reference.id}, changed_now(name)};
  };
  // In a farm the head has moved once the table has it, whether this disk takes it or not.
  commit_designs(move, designs_ ? Store::OnFullDisk::GoOn : Store::OnFullDisk::Throw);
  set.design =
      *store_.read([&](Catalogue& catalogue) { return catalogue.design(set.design.name); });
  return set;
}

Archive::DesignRemoved Archive::remove_design(const std::string& design,
                                              const std::string& expected) {
  look_at_design(design);
  DesignRemoved removed;
  std::vector<std::string> gone;
  const auto take_out = [&](Catalogue& catalogue) {
    removed = {};
    gone.clear();
    check_expected(listed_design(catalogue, design), expected);
    Transaction changes{SetHead{design, ""}};
    for (const PlaceRecord& place : catalogue.places_of(design)) {
      changes.emplace_back(RemovePlace{design, place.number});
      ++removed.revisions;
      if (catalogue.places(place.id).size() > 1) continue;
      changes.emplace_back(RemoveRevision{place.id});
      gone.push_back(place.id);
    }
    AddDesign off_the_list = changed_now(design);
    off_the_list.listed = false;
    changes.emplace_back(off_the_list);
    return changes;
  };
  commit_designs(take_out, Store::OnFullDisk::GoOn);
  for (const std::string& id : gone) forget(id);
  removed.meshes_deleted = static_cast<std::uint32_t>(gone.size());
  return removed;
}

Archive::Removed Archive::remove(const std::string& text, bool allow_head) {
  look_at_places(resolve(text).id);
  Removed removed;
  const auto take_out = [&](Catalogue& catalogue) {
    removed = {};
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
      changes.emplace_back(changed_now(place.design));
      if (!place.head) continue;
      const auto last = catalogue.last_place(place.design, reference.id);
      changes.emplace_back(SetHead{place.design, last ? last->id : ""});
    }
    removed.mesh_deleted = !elsewhere;
    if (!elsewhere) changes.emplace_back(RemoveRevision{reference.id});
    return changes;
  };
  commit_designs(take_out, Store::OnFullDisk::GoOn);
  if (removed.mesh_deleted) forget(removed.id);
  return removed;
}

}  // namespace remeshd
