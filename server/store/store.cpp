#include "server/store/store.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <exception>
#include <thread>
#include <tuple>

#include "engine/base/error.h"
#include "server/store/first_layout.h"
#include "server/store/packed_text.h"
#include "server/store/quarantine.h"
#include "server/store/store_error.h"
#include "server/store/store_format.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

// A journal is rewritten when most of its lines tell of what is no more.
constexpr std::uint64_t kFewLines = 1000;
constexpr std::uint64_t kMostLinesPerKept = 4;  // per revision or recipe

void make_folders(const fs::path& folder) {
  if (fs::is_directory(folder)) return;
  if (folder.has_parent_path() && folder.parent_path() != folder)
    make_folders(folder.parent_path());
  make_folder(folder);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

}  // namespace

Store::Store() : catalogue_(std::make_unique<Catalogue>()) {}

Store::~Store() = default;

Store::Store(const fs::path& folder, double wait)
    : folder_(fs::absolute(folder)), catalogue_(std::make_unique<Catalogue>()) {
  try {
    open(wait);
  } catch (const Error& failure) {
    ErrorInfo info = failure.info();
    if (info.message.find(folder_.string()) == std::string::npos)
      info.message += " (store " + folder_.string() + ")";
    throw Error(std::move(info));
  } catch (const fs::filesystem_error& failure) {
    throw error::store_failed("reading", folder_.string(), failure.code().value());
  }
}

void Store::open(double wait) {
  make_folders(folder_);
  look_at_folder(folder_);  // before `lock` is made in what may be anything
  lock_folder(wait);
  const FolderKind kind = look_at_folder(folder_);
  for (const char* name : {"tmp", "packs"}) make_folder(folder_ / name);
  const fs::path scratch = folder_ / "tmp";
  old_scratch_ = files_in(scratch);
  Quarantine quarantine(folder_ / "quarantine", scratch);
  if (kind != FolderKind::Store) {
    if (kind == FolderKind::Unmarked && fs::exists(folder_ / "FORMAT"))
      quarantine.take(folder_ / "FORMAT", "it was damaged");
    write_format(folder_, scratch);
  }

  packs_ = std::make_unique<Packs>(folder_ / "packs", scratch);
  journal_ = std::make_unique<Journal>(folder_, scratch);
  journal_behind_ = !journal_->whole();
  std::vector<Transaction> transactions = journal_->take_transactions();
  const FirstLayout first_layout(folder_);
  const bool older = first_layout.present();
  if (older) {
    if (transactions.empty()) transactions = first_layout.transactions();
    first_layout.bring_in(*packs_, quarantine);
  }
  load(std::move(transactions));
  for (const fs::path& stranger : packs_->strangers())
    quarantine.take(stranger, "it is no revision");
  adopt_unknown_packs(quarantine);

  if (!journal_->unreadable().empty())
    quarantine.keep("journal", journal_->unreadable(), "lines of the journal that are damaged");
  if (journal_->lost() > 0)
    notes_.push_back(std::to_string(journal_->lost()) + " lines of the journal are lost");
  for (const fs::path& file : journal_->failed_files()) quarantine.take(file, "it cannot be read");
  if (journal_behind_) {
    try {
      rewrite_journal({});
    } catch (const Error& failure) {
      // Nothing is lost by it: the next opening finds what this one found.
      notes_.push_back(std::string("the journal could not be rewritten: ") + failure.what());
    }
  }
  if (older && !journal_behind_) first_layout.put_away(quarantine);
  notes_.insert(notes_.end(), quarantine.notes().begin(), quarantine.notes().end());
}

void Store::lock_folder(double wait) {
  using std::chrono::steady_clock;
  const auto until = steady_clock::now() + std::chrono::duration<double>(wait);
  lock_ = File(folder_ / "lock", O_RDWR | O_CREAT);
  while (::flock(lock_.descriptor(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR)
      throw error::store_failed("locking", folder_.string(), errno);
    if (steady_clock::now() >= until) throw error::store_locked(folder_.string());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void Store::load(std::vector<Transaction> transactions) {
  for (const Transaction& transaction : transactions)
    for (const Operation& operation : transaction) {
      if (const auto* gone = std::get_if<RemoveRevision>(&operation)) leftovers_[gone->id];
      if (const auto* dropped = std::get_if<DropMesh>(&operation)) leftovers_[dropped->id];
      if (const auto* added = std::get_if<AddRevision>(&operation))
        leftovers_.erase(added->record.id);
    }
  if (const std::size_t failed = catalogue_->apply_all(transactions); failed > 0)
    notes_.push_back(std::to_string(failed) + " lines of the journal contradict those before them");
}

void Store::adopt_unknown_packs(Quarantine& quarantine) {
  std::vector<PackHead> found;
  std::map<std::string, std::string> gone;
  for (const std::string& id : packs_->list()) {
    if (catalogue_->is_stored(id)) continue;
    auto head = packs_->head(id);
    if (leftovers_.contains(id)) {
      gone[id] = head ? head->record.base : "";
      continue;
    }
    if (!head || head->record.id != id) {
      quarantine.take(packs_->path_of(id), "its head cannot be read");
    } else if (journal_->intact() && !packs_->is_whole(id)) {
      gone[id] = head->record.base;  // of a write that a crash cut off
    } else {
      found.push_back(std::move(*head));
    }
  }
  leftovers_ = std::move(gone);
  const auto by_number = [](const PackHead& a, const PackHead& b) {
    return std::tie(a.first.design, a.first.number, a.record.id) <
           std::tie(b.first.design, b.first.number, b.record.id);
  };
  std::sort(found.begin(), found.end(), by_number);
  std::map<std::string, std::string> heads;  // of designs; to count their revisions takes long
  for (const PackHead& head : found) {
    const std::string& design = head.first.design;
    Transaction adopt{AddRevision{head.record, head.recipe}};
    if (design.empty() || catalogue_->revision(head.record.id)) {
      catalogue_->apply(adopt);
      continue;
    }
    const auto [now, fresh] = heads.try_emplace(design);
    if (const auto known = fresh ? catalogue_->design(design) : std::nullopt)
      now->second = known->head;
    // A later line of the journal may have told of its place.
    const auto places = catalogue_->places(head.record.id);
    if (std::none_of(places.begin(), places.end(),
                     [&](const PlaceRecord& place) { return place.design == design; })) {
      const bool taken = catalogue_->at(design, head.first.number).has_value();
      adopt.emplace_back(AddPlace{
          design, taken ? catalogue_->next_number(design) : head.first.number, head.record.id});
    }
    // As the edit that made it did, unless it asked for something else.
    if (now->second.empty() || now->second == head.record.parent) {
      adopt.emplace_back(SetHead{design, head.record.id});
      now->second = head.record.id;
    }
    catalogue_->apply(adopt);
  }
  if (found.empty()) return;
  journal_behind_ = true;
  notes_.push_back(std::to_string(found.size()) +
                   " revisions that the journal does not name were entered again");
}

void Store::put(RevisionRecord& record, const PlaceRecord& first, const std::string& recipe,
                const StoredArrays& arrays, const Packs::Base* base) {
  if (!persistent()) return;
  {
    const std::scoped_lock lock(committing_);
    leftovers_.erase(record.id);
    unfiled_[record.id] = base != nullptr ? base->id : "";
  }
  try {
    const Packs::Written written = packs_->put(record, first, packed_recipe(recipe), arrays, base);
    record.bytes = written.bytes;
    record.base = written.base;
    set_healthy(true);
  } catch (...) {
    set_healthy(false);
    discard(record.id);
    throw;
  }
}

void Store::discard(const std::string& id) {
  const std::scoped_lock lock(committing_);
  const auto unfiled = unfiled_.find(id);
  if (unfiled == unfiled_.end()) return;
  const std::scoped_lock reading(reading_);
  if (!catalogue_->is_stored(id)) leftovers_[id] = unfiled->second;
  unfiled_.erase(unfiled);
  // Deleted by the next commit: the disk may be in trouble now.
}

StoredArrays Store::get(const std::string& id) { return packs_->get(id); }

std::string Store::fault_of(const std::string& id) const { return packs_->fault_of(id); }

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
  set_healthy(true);
}

bool Store::commit(const std::function<Transaction(Catalogue&)>& make, OnFullDisk on_full_disk) {
  const std::scoped_lock lock(committing_);
  Transaction transaction;
  std::map<std::string, std::string> removed;
  try {
    const std::scoped_lock reading(reading_);
    transaction = make(*catalogue_);
    if (transaction.empty()) return true;
    for (const Operation& operation : transaction) {
      const auto* gone = std::get_if<RemoveRevision>(&operation);
      const auto* dropped = std::get_if<DropMesh>(&operation);
      if (gone == nullptr && dropped == nullptr) continue;
      const std::string& id = gone != nullptr ? gone->id : dropped->id;
      if (const auto record = catalogue_->revision(id)) removed[id] = record->base;
    }
    if (persistent()) catalogue_->check(transaction);
  } catch (...) {
    drop_added(transaction);
    throw;
  }
  bool entered = true;
  if (persistent()) {
    try {
      enter(transaction);
      set_healthy(true);
    } catch (const Error& failure) {
      set_healthy(false);
      entered = false;
      if (on_full_disk == OnFullDisk::Throw || failure.info().reason != "STORE_FULL") {
        drop_added(transaction);
        throw;
      }
      journal_behind_ = true;
    } catch (...) {
      drop_added(transaction);
      throw;
    }
  }
  apply(transaction);
  if (!persistent()) return true;
  for (const Operation& operation : transaction)
    if (const auto* added = std::get_if<AddRevision>(&operation)) unfiled_.erase(added->record.id);
  leftovers_.merge(removed);
  if (entered) tidy();
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
  if (journal_->lines() > many_lines_)  // to count takes long
    many_lines_ = kFewLines + kMostLinesPerKept *
                                  read([](Catalogue& catalogue) { return catalogue.count_kept(); });
  if (journal_behind_ || journal_->uncertain() || journal_->lines() > many_lines_) {
    rewrite_journal(transaction);
    return;
  }
  const JournalPlace line = journal_->append(transaction);
  for (Operation& operation : transaction)
    if (KeptRecipe* recipe = recipe_in(operation).recipe) *recipe = KeptRecipe(line);
}

void Store::rewrite_journal(const Transaction& last) {
  std::vector<Transaction> all = read([&](Catalogue& catalogue) {
    std::vector<Transaction> snapshot = catalogue.snapshot();
    for (const auto& [id, base] : leftovers_)
      if (!catalogue.revision(id)) {
        snapshot.push_back({RemoveRevision{id}});
      } else if (!catalogue.is_stored(id)) {
        snapshot.push_back({DropMesh{id}});
      }
    return snapshot;
  });
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
    unfiled_.erase(added->record.id);
    if (!read([&](Catalogue& catalogue) { return catalogue.is_stored(added->record.id); }))
      leftovers_[added->record.id] = added->record.base;
  }
  // Where the disk may have the line all the same, the bytes stay until the journal is rewritten.
  if (!journal_->uncertain()) tidy();
}

bool Store::is_needed(const std::string& id) {
  const auto stands_on_it = [&](const auto& other) { return other.second == id; };
  return unfiled_.contains(id) || std::ranges::any_of(unfiled_, stands_on_it) ||
         std::ranges::any_of(leftovers_, stands_on_it) || read([&](Catalogue& catalogue) {
           return catalogue.is_stored(id) || catalogue.is_base(id);
         });
}

void Store::tidy() {
  const auto removed = [](const auto& remove) {
    try {
      remove();
      return true;
    } catch (const Error&) {
      return false;  // the next commit tries again
    }
  };
  std::erase_if(leftovers_, [&](const auto& leftover) {
    return read([&](Catalogue& catalogue) { return catalogue.is_stored(leftover.first); });
  });
  // Deleting one may set free the one that it is told by.
  for (bool again = true; again;) {
    again = std::erase_if(leftovers_, [&](const auto& leftover) {
              return !is_needed(leftover.first) && removed([&] { packs_->remove(leftover.first); });
            }) > 0;
  }
  std::erase_if(old_scratch_,
                [&](const fs::path& file) { return removed([&] { remove_file(file); }); });
}

void Store::on_health(std::function<void(bool)> listener) {
  const std::scoped_lock lock(health_);
  health_listener_ = std::move(listener);
  if (health_listener_) health_listener_(healthy_);
}

void Store::set_healthy(bool healthy) {
  if (healthy_ == healthy) return;
  const std::scoped_lock lock(health_);
  if (healthy_.exchange(healthy) != healthy && health_listener_) health_listener_(healthy);
}

}  // namespace remeshd
