#include "server/session/archive.h"

#include <algorithm>
#include <utility>

#include "server/admission/load_error.h"
#include "server/session/changed_now.h"
#include "server/session/fail_on.h"
#include "server/session/head_decision.h"
#include "server/session/session_error.h"
#include "server/session/written_mesh.h"

namespace remeshd {
namespace {

/// `made`: the place of the revision that does not become the head. Where the warning is an error
/// it is not filed.
Warning head_kept(const PlaceRecord& made, std::uint32_t head) {
  return {.code = WarningCode::HeadKept,
          .message = "the head of the design `" + made.design + "` is still number " +
                     std::to_string(head) + ", for this model is not that of its first revision; " +
                     "`remesh mesh --head` makes it the head, and so does `remesh head " +
                     made.design + "@" + std::to_string(made.number) + "` once it is filed"};
}

Warning not_durable() {
  return {.code = WarningCode::NotDurable,
          .message =
              "the revision is in memory alone, for the store is full; it is stored as soon "
              "as there is room"};
}

void set_not_durable(Filed& filed) {
  if (std::exchange(filed.durable, false)) filed.warnings.push_back(not_durable());
}

}  // namespace

Archive::Archive(const Engine& engine, Store& store, MemoryBudget& memory, DiskBudget* disk,
                 Metrics* metrics, SharedParts shared)
    : engine_(engine),
      store_(store),
      shared_(std::move(shared.revisions)),
      designs_(std::move(shared.designs)),
      homes_(std::move(shared.homes)),
      memory_(memory),
      metrics_(metrics),
      held_(memory, store.persistent(), engine.memory_blocks,
            [this] {
              if (metrics_ != nullptr) metrics_->evicted(Metrics::Tier::Memory);
            }),
      disk_(store.persistent() ? disk : nullptr),
      saver_(store.persistent() ? std::function<bool()>([this] { return recover(); })
                                : std::function<bool()>(),
             // A second later: the store reports a failure shortly before `file` notes the revision
             // that the disk did not take.
             Background::Begin::AfterASecond) {
  store_.on_failure([this] { saver_.ask(); });
  if (disk_ == nullptr) return;
  const auto bytes = [this] { return store_.bytes(); };
  const auto shrink = [this](std::uint64_t most) { collect_garbage({.disk_bytes = most}); };
  disk_holder_ = disk_->add_holder({.bytes = bytes, .shrink = shrink});
}

Archive::~Archive() {
  store_.on_failure({});
  if (disk_ != nullptr) disk_->remove_holder(disk_holder_);
}

Reference Archive::resolve(const std::string& text) {
  if (shared_ && is_full_id(text) && !is_known(text)) adopt(text);
  look_at_named(text);
  return store_.read([&](Catalogue& catalogue) { return remeshd::resolve(catalogue, text); });
}

void Archive::check_room(std::uint64_t bytes) const {
  if (bytes > memory_.total()) throw error::never_fits(bytes, memory_.total());
  if (store_.persistent()) return;
  const std::uint64_t held = memory_.held();
  if (held >= memory_.most_held() || held + bytes > memory_.total())
    throw error::memory_full(held, std::min(memory_.most_held(), memory_.total()));
}

void Archive::drop_unfiled(const std::string& id) {
  const std::scoped_lock lock(filing_);
  if (!store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); })) held_.erase(id);
}

Archive::Filing Archive::plan_filing(Catalogue& catalogue, const RevisionRecord& record,
                                     const std::string& design, const HeadRule& rule,
                                     const std::vector<WarningCode>& fail_on) const {
  homes_.check(design);
  Filing filing;
  Filed& filed = filing.filed;
  filed.durable = is_durable(record.id);
  HeadSituation now{.id = record.id, .first_mesh = record.parent.empty()};
  const auto known = catalogue.revision(record.id);
  filed.record = known.value_or(record);
  filing.add = !known;
  if (filing.add) filing.changes.emplace_back(AddRevision{filed.record});
  if (store_.persistent() && !filed.durable) filed.warnings.push_back(not_durable());
  if (design.empty()) {
    filed.place.id = record.id;
    check_warnings(filed.warnings, fail_on);
    return filing;
  }
  filed.place = {.design = design, .number = catalogue.next_number(design), .id = record.id};
  for (const PlaceRecord& place : catalogue.places(record.id)) {
    if (place.design != design) continue;
    filed.place.number = place.number;
    now.is_new = false;
  }
  if (const auto found = catalogue.design(design)) {
    now.head = found->head;
    filed.head_number = found->head_number;
  }
  if (const auto first = catalogue.first_place(design)) {
    const auto of_first = catalogue.revision(first->id);
    now.same_model = of_first && of_first->model == record.model && !record.model.empty();
  }

  const HeadDecision decision = decide_head(rule, now);
  if (decision.conflict && rule.require)
    throw error::head_conflict(design, rule.expected, now.head);
  if (decision.kept) filed.warnings.push_back(head_kept(filed.place, filed.head_number));
  check_warnings(filed.warnings, fail_on);
  filed.head_conflict = decision.conflict;
  filed.head = decision.move ? record.id : now.head;
  if (decision.move) filed.head_number = filed.place.number;
  filed.place.head = filed.head == record.id;

  if (now.is_new) filing.changes.emplace_back(AddPlace{design, filed.place.number, record.id});
  if (decision.move) filing.changes.emplace_back(SetHead{design, record.id});
  if (now.is_new || decision.move) filing.changes.emplace_back(changed_now(design));
  return filing;
}

void Archive::check_filing(const RevisionRecord& record, const std::string& design,
                           const HeadRule& rule, const std::vector<WarningCode>& fail_on) {
  look_at_design(design);
  store_.read([&](Catalogue& catalogue) { plan_filing(catalogue, record, design, rule, fail_on); });
}

Filed Archive::file(const HeldRevisionPtr& revision, const std::string& design,
                    const HeadRule& rule, const std::vector<WarningCode>& fail_on) {
  if (designs_ && !design.empty()) return file_with_others(revision, design, rule, fail_on);
  const std::string& id = revision->record.id;
  const auto plan = [&](Catalogue& catalogue) {
    return plan_filing(catalogue, revision->record, design, rule, fail_on);
  };
  if (is_known(id)) note_use(id);  // a new one is used now anyhow, or refused
  if (is_known(id) && is_durable(id)) {
    try {
      keep(revision);
    } catch (const Error& failure) {
      // The store has its recipe; the mesh is stored again when there is room.
      if (failure.info().reason != "STORE_FULL") throw;
    }
  }
  Filing filing = store_.read(plan);
  if (filing.changes.empty() && store_.persistent()) return filing.filed;

  const bool must_last = std::ranges::find(fail_on, WarningCode::NotDurable) != fail_on.end();
  const auto on_full_disk = must_last ? Store::OnFullDisk::Throw : Store::OnFullDisk::GoOn;
  for (;;) {
    std::optional<OneAtATime::Turn> turn;
    std::optional<Written> written;
    if (store_.persistent() && !is_known(id)) {
      turn.emplace(writing_.take(id));
      if (!is_known(id)) written = write_if_there_is_room(*revision, filing.filed.place);
      if (written && written->record.bytes == 0) check_warnings({{not_durable()}}, fail_on);
    }
    const std::scoped_lock lock(filing_);
    bool again = false;
    try {
      const auto make = [&](Catalogue& catalogue) {
        filing = plan(catalogue);
        if (!filing.add || !store_.persistent()) return filing.changes;
        again = !written;  // it was deleted a moment ago
        if (again) return Transaction{};
        filing.filed.record = written->record;
        filing.changes.front() = AddRevision{written->record, written->recipe};
        return filing.changes;
      };
      if (!store_.commit(make, on_full_disk)) set_not_durable(filing.filed);
    } catch (const Error& failure) {
      if (written) store_.discard(id);
      if (failure.info().reason == "STORE_FULL") check_warnings({{not_durable()}}, fail_on);
      throw;
    } catch (...) {
      if (written) store_.discard(id);
      throw;
    }
    if (again) continue;
    if (written && written->record.bytes == 0) set_not_durable(filing.filed);
    // It may have been dropped, unfiled or deleted, since the caller found it.
    if (!held_.contains(id)) held_.insert(revision);
    if (!filing.filed.durable && store_.persistent()) {  // `recover` saves it from memory
      set_unsaved(id, true);
      saver_.ask();
    }
    if (written && disk_ != nullptr) disk_->look_soon();
    return filing.filed;
  }
}

void Archive::forget(const std::string& id) {
  const std::scoped_lock lock(filing_);
  if (is_known(id)) return;  // it was filed again since it was deleted
  held_.erase(id);
  set_damaged(id, false);
  set_unsaved(id, false);
  const std::scoped_lock notes(notes_);
  used_.erase(id);
}

}  // namespace remeshd
