#include "server/store/store.h"

#include <exception>
#include <utility>

#include "engine/base/error.h"
#include "server/store/packed_text.h"
#include "server/store/quarantine.h"
#include "server/store/store_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

// A journal is rewritten when most of its lines tell of what is no more.
constexpr std::uint64_t kFewLines = 1000;
constexpr std::uint64_t kMostLinesPerKept = 4;  // per line that a rewrite keeps, by half the count
// Bytes that are written to see whether the disk takes some: what a large edit needs.
constexpr std::size_t kTrial = std::size_t{1} << 20;

}  // namespace

Store::Store() : catalogue_(std::make_unique<Catalogue>()) {}

Store::~Store() = default;

Store::Store(const fs::path& folder, double wait)
    : Store(fs::absolute(folder), open_store(fs::absolute(folder), wait)) {}

Store::Store(fs::path folder, OpenedStore opened)
    : folder_(std::move(folder)),
      lock_(std::move(opened.lock)),
      packs_(std::move(opened.packs)),
      journal_(std::move(opened.journal)),
      catalogue_(std::move(opened.catalogue)),
      journal_behind_(opened.journal_behind),
      leftovers_(std::move(opened.leftovers)),
      old_scratch_(std::move(opened.old_scratch)),
      notes_(std::move(opened.notes)) {
  count_leftovers();
}

void Store::put(RevisionRecord& record, const PlaceRecord& first, const std::string& recipe,
                const StoredArrays& arrays, const Packs::Base* base) {
  if (!persistent()) return;
  put_with(record, base != nullptr ? base->id : "",
           [&] { return packs_->put(record, first, packed_recipe(recipe), arrays, base); });
}

void Store::take_in(RevisionRecord& record, std::string_view pack) {
  put_with(record, record.base, [&] { return packs_->take_in(record, pack); });
}

void Store::put_with(RevisionRecord& record, const std::string& base,
                     const std::function<Packs::Written()>& write) {
  {
    const std::scoped_lock lock(committing_);
    leftovers_.erase(record.id);
    count_leftovers();
    unfiled_[record.id] = base;
  }
  try {
    const Packs::Written written = write();
    record.bytes = written.bytes;
    record.base = written.base;
    set_healthy(true);
  } catch (const Error& failure) {
    if (failure.info().reason != "STORE_CORRUPTED") set_healthy(false);
    discard(record.id);
    throw;
  } catch (...) {
    set_healthy(false);
    discard(record.id);
    throw;
  }
}

// While a pack is read, it may be rewritten against another base, and its old base be deleted. So a
// read that fails while packs are being deleted is repeated.

StoredArrays Store::get(const std::string& id) {
  for (;;) {
    const std::uint64_t before = deletions_;
    try {
      return packs_->get(id);
    } catch (const Error&) {
      if (deletions_ == before) throw;
    }
  }
}

std::string Store::pack(const std::string& id) {
  for (;;) {
    const std::uint64_t before = deletions_;
    try {
      return packs_->file(id);
    } catch (const Error&) {
      if (deletions_ == before) throw;
    }
  }
}

std::string Store::quarantine(std::string_view name, std::string_view bytes, std::string_view why) {
  Quarantine quarantine(folder_ / "quarantine", folder_ / "tmp");
  quarantine.keep(name, bytes, why);
  return quarantine.notes().front();
}

std::string Store::fault_of(const std::string& id) const {
  for (;;) {
    const std::uint64_t before = deletions_;
    std::string fault = packs_->fault_of(id);
    if (fault.empty() || deletions_ == before) return fault;
  }
}

std::string Store::recipe(const std::string& id) {
  const std::string bytes = packed_recipe_of(id);
  return bytes.empty() ? bytes : unpacked(bytes);
}

std::string Store::packed_recipe_of(const std::string& id) {
  // Places of lines change when the journal is rewritten.
  const std::scoped_lock lock(committing_);
  KeptRecipe kept = read([&](Catalogue& catalogue) { return catalogue.recipe(id); });
  std::exception_ptr failure;
  try {
    if (kept.place) kept.bytes = journal_->recipe(id, *kept.place);
  } catch (const Error&) {
    failure = std::current_exception();
  }
  if (!kept.bytes.empty() || !persistent()) return kept.bytes;
  if (auto head = packs_->head(id); head && !head->recipe.empty()) return head->recipe;
  if (failure) std::rethrow_exception(failure);
  return {};
}

Store::Room Store::room() const {
  Room room;
  if (!persistent()) return room;
  std::error_code failure;
  const fs::space_info space = fs::space(folder_, failure);
  if (!failure) room.free_bytes = space.available;
  for (fs::recursive_directory_iterator entry(folder_ / "quarantine", failure), end;
       !failure && entry != end; entry.increment(failure))
    room.quarantined += entry->is_regular_file(failure);
  return room;
}

std::string Store::packed_recipe(const std::string& recipe) {
  return recipe.empty() ? recipe : packed(recipe);
}

void Store::flush() {
  const std::scoped_lock lock(committing_);
  if (!persistent()) return;
  try {
    if (journal_behind_ || journal_->uncertain()) rewrite_journal({});
  } catch (...) {
    set_healthy(false);
    throw;
  }
}

void Store::try_disk() {
  if (!persistent() || healthy_) return;
  const std::scoped_lock lock(committing_);
  try_writing(kTrial, folder_ / "tmp");
  set_healthy(true);
}

bool Store::commit(const std::function<Transaction(Catalogue&)>& make, OnFullDisk on_full_disk) {
  const std::scoped_lock lock(committing_);
  Transaction transaction;
  Leftovers removed;
  try {
    const std::scoped_lock reading(reading_);
    transaction = make(*catalogue_);
    if (transaction.empty()) return true;
    for (const Operation& operation : transaction) {
      const auto* gone = std::get_if<RemoveRevision>(&operation);
      const auto* dropped = std::get_if<DropMesh>(&operation);
      if (gone == nullptr && dropped == nullptr) continue;
      const std::string& id = gone != nullptr ? gone->id : dropped->id;
      if (const auto record = catalogue_->revision(id)) removed[id] = {record->base, record->bytes};
    }
    if (persistent()) catalogue_->check(transaction);
  } catch (...) {
    drop_added(transaction);
    throw;
  }
  bool entered = true;
  if (persistent()) {
    try {
      enter(transaction);  // not yet healthy: room for a line is not room for a pack
    } catch (const Error& failure) {
      set_healthy(false);
      entered = false;
      if (on_full_disk == OnFullDisk::Throw || failure.info().reason != "STORE_FULL") {
        drop_added(transaction);
        throw;
      }
    } catch (...) {
      drop_added(transaction);
      throw;
    }
  }
  apply(transaction);
  if (!persistent()) return true;
  for (const Operation& operation : transaction)
    if (const auto* added = std::get_if<AddRevision>(&operation)) unfiled_.erase(added->record.id);
  leftovers_.insert(removed.begin(), removed.end());
  count_leftovers();
  if (!entered) entered = enter_in_room_of(removed, transaction);
  if (entered) tidy();
  return entered;
}

/// For a transaction that the journal has no room for: deletes the packs of what it removes, then
/// enters it. A crash in between leaves revisions whose mesh is made again of its recipe.
bool Store::enter_in_room_of(const Leftovers& removed, const Transaction& transaction) {
  bool entered = false;
  if (!removed.empty()) {
    delete_packs([&](const std::string& id) { return removed.contains(id); });
    try {
      if (journal_behind_ || journal_->uncertain()) {
        rewrite_journal({});
      } else {
        journal_->append(transaction);
      }
      entered = true;
      set_healthy(true);
    } catch (const Error&) {
      // It stays in memory alone, as others for which there was no room.
    }
  }
  journal_behind_ = journal_behind_ || !entered;
  return entered;
}

void Store::apply(const Transaction& transaction) {
  const std::scoped_lock reading(reading_);
  try {
    catalogue_->apply(transaction);
  } catch (...) {
    // The journal has what the catalogue has not: it is written anew before the next line.
    journal_behind_ = true;
    throw;
  }
}

void Store::enter(Transaction& transaction) {
  if (journal_->lines() > many_lines_) {  // to count takes long
    const std::uint64_t kept =
        leftovers_.size() + read([](Catalogue& catalogue) { return catalogue.count_lines(); });
    many_lines_ = kFewLines + kMostLinesPerKept * kept;
  }
  if (journal_behind_ || journal_->uncertain() || journal_->lines() > many_lines_) {
    rewrite_journal(transaction);
    return;
  }
  const JournalPlace line = journal_->append(transaction);
  for (Operation& operation : transaction)
    if (KeptRecipe* recipe = recipe_in(operation).recipe) *recipe = KeptRecipe(line);
}

void Store::rewrite_journal(const Transaction& last) {
  std::vector<Transaction> all =
      read([&](Catalogue& catalogue) { return lines_of(catalogue, leftovers_); });
  if (!last.empty()) all.push_back(last);
  journal_->rewrite(all, [&](const std::vector<RecipePlace>& places) {
    read([&](Catalogue& catalogue) { catalogue.set_recipe_places(places); });
  });
  journal_behind_ = false;
}

void Store::drop_added(const Transaction& transaction) {
  if (!persistent()) return;
  for (const Operation& operation : transaction) {
    const auto* added = std::get_if<AddRevision>(&operation);
    if (added == nullptr) continue;
    const RevisionRecord& put = added->record;
    unfiled_.erase(put.id);
    auto now = read([&](Catalogue& catalogue) { return catalogue.revision(put.id); });
    if (!now || now->bytes == 0) {
      leftovers_[put.id] = {put.base, packs_->bytes_of(put.id)};
    } else if (now->base != put.base || now->bytes != put.bytes) {
      // Its pack has been replaced: the catalogue has to know the base that the new one needs.
      now->base = put.base;
      now->bytes = put.bytes;
      journal_behind_ = true;
      apply({AddRevision{*now}});
    }
  }
  count_leftovers();
  // Where the disk may have the line all the same, the bytes stay until the journal is rewritten.
  if (!journal_->uncertain()) tidy();
}

void Store::on_health(std::function<void(bool)> listener) {
  const std::scoped_lock lock(health_);
  health_listener_ = std::move(listener);
  if (health_listener_) health_listener_(healthy_);
}

void Store::on_failure(std::function<void()> listener) {
  const std::scoped_lock lock(health_);
  failure_listener_ = std::move(listener);
  if (failure_listener_ && !healthy_) failure_listener_();
}

void Store::set_healthy(bool healthy) {
  if (healthy_ == healthy) return;
  const std::scoped_lock lock(health_);
  if (healthy_.exchange(healthy) == healthy) return;
  if (health_listener_) health_listener_(healthy);
  if (!healthy && failure_listener_) failure_listener_();
}

}  // namespace remeshd
