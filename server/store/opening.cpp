#include "server/store/opening.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>
#include <tuple>
#include <utility>

#include "engine/base/error.h"
#include "server/store/first_layout.h"
#include "server/store/quarantine.h"
#include "server/store/store_error.h"
#include "server/store/store_format.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

// A pack that was replaced so long before the last line of the journal has its line there.
constexpr std::int64_t kToEnter = 60'000'000'000;  // ns

void make_folders(const fs::path& folder) {
  if (fs::is_directory(folder)) return;
  if (folder.has_parent_path() && folder.parent_path() != folder)
    make_folders(folder.parent_path());
  make_folder(folder);
}

/// Opens a store, step by step, into `opened_`.
class Opening {
 public:
  Opening(fs::path folder, double wait) : folder_(std::move(folder)) { open(wait); }
  OpenedStore take() { return std::move(opened_); }

 private:
  void open(double wait);
  void lock_folder(double wait);
  void sort_scratch(const fs::path& scratch, Quarantine& quarantine);
  void load(const std::vector<Transaction>& transactions);
  void follow_replaced_packs(std::int64_t since);
  bool was_cut_off(const std::string& id);
  void adopt_unknown_packs(Quarantine& quarantine);
  void enter_again(const PackHead& head, std::map<std::string, std::string>& heads);

  const fs::path folder_;
  OpenedStore opened_;
};

void Opening::open(double wait) {
  make_folders(folder_);
  look_at_folder(folder_);  // before `lock` is made in a folder that may be anything
  lock_folder(wait);
  const FolderKind kind = look_at_folder(folder_);
  for (const char* name : {"tmp", "packs"}) make_folder(folder_ / name);
  const fs::path scratch = folder_ / "tmp";
  Quarantine quarantine(folder_ / "quarantine", scratch);
  sort_scratch(scratch, quarantine);
  if (kind != FolderKind::Store) {
    if (kind == FolderKind::Unmarked && fs::exists(folder_ / "FORMAT"))
      quarantine.take(folder_ / "FORMAT", "it was damaged");
    write_format(folder_, scratch);
  }

  const std::int64_t last_line = changed_ns(folder_ / "journal.a");
  opened_.packs = std::make_unique<Packs>(folder_ / "packs", scratch);
  opened_.journal = std::make_unique<Journal>(folder_, scratch);
  opened_.journal_behind = !opened_.journal->whole();
  std::vector<Transaction> transactions = opened_.journal->take_transactions();
  const FirstLayout first_layout(folder_);
  const bool older = first_layout.present();
  if (older) {
    if (transactions.empty()) transactions = first_layout.transactions();
    first_layout.bring_in(*opened_.packs, quarantine);
  }
  load(transactions);
  follow_replaced_packs(last_line - kToEnter);
  for (const fs::path& stranger : opened_.packs->strangers())
    quarantine.take(stranger, "it is no revision");
  adopt_unknown_packs(quarantine);

  if (!opened_.journal->unreadable().empty())
    quarantine.keep("journal", opened_.journal->unreadable(),
                    "lines of the journal that are damaged");
  if (opened_.journal->lost() > 0)
    opened_.notes.push_back(std::to_string(opened_.journal->lost()) +
                            " lines of the journal are lost");
  for (const fs::path& file : opened_.journal->failed_files())
    quarantine.take(file, "it cannot be read");
  if (opened_.journal_behind) {
    try {
      opened_.journal->rewrite(lines_of(*opened_.catalogue, opened_.leftovers),
                               [&](const std::vector<RecipePlace>& places) {
                                 opened_.catalogue->set_recipe_places(places);
                               });
      opened_.journal_behind = false;
    } catch (const Error& failure) {
      // Nothing is lost by it: the next opening finds what this one found.
      opened_.notes.push_back(std::string("the journal could not be rewritten: ") + failure.what());
    }
  }
  if (older && !opened_.journal_behind) first_layout.put_away(quarantine);
  opened_.notes.insert(opened_.notes.end(), quarantine.notes().begin(), quarantine.notes().end());
}

void Opening::lock_folder(double wait) {
  using std::chrono::steady_clock;
  const auto until = steady_clock::now() + std::chrono::duration<double>(wait);
  opened_.lock = File(folder_ / "lock", O_RDWR | O_CREAT);
  while (::flock(opened_.lock.descriptor(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR)
      throw error::store_failed("locking", folder_.string(), errno);
    if (steady_clock::now() >= until) throw error::store_locked(folder_.string());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// Notes scratch files of earlier processes, to be deleted later; all else goes to the quarantine.
void Opening::sort_scratch(const fs::path& scratch, Quarantine& quarantine) {
  std::vector<fs::path> strangers;
  for (const auto& entry : fs::directory_iterator(scratch)) {
    const bool file = entry.is_regular_file() && !entry.is_symlink();
    const bool ours = file && is_scratch_name(entry.path().filename().string());
    (ours ? opened_.old_scratch : strangers).push_back(entry.path());
  }
  std::ranges::sort(strangers);
  for (const fs::path& stranger : strangers) quarantine.take(stranger, "no store was writing it");
}

void Opening::load(const std::vector<Transaction>& transactions) {
  for (const Transaction& transaction : transactions)
    for (const Operation& operation : transaction) {
      if (const auto* gone = std::get_if<RemoveRevision>(&operation)) opened_.leftovers[gone->id];
      if (const auto* dropped = std::get_if<DropMesh>(&operation)) opened_.leftovers[dropped->id];
      if (const auto* added = std::get_if<AddRevision>(&operation))
        opened_.leftovers.erase(added->record.id);
    }
  if (const std::size_t failed = opened_.catalogue->apply_all(transactions); failed > 0)
    opened_.notes.push_back(std::to_string(failed) +
                            " lines of the journal contradict those before them");
}

/// Enters the bases of packs that were replaced, against another base, just before a crash: the
/// catalogue knows the base of the pack before, and would let the new one be deleted. `since`: ns
/// since 1970; packs that have not changed since then are not read.
void Opening::follow_replaced_packs(std::int64_t since) {
  for (const std::string& id : opened_.packs->list()) {
    if (changed_ns(opened_.packs->path_of(id)) < since || !opened_.catalogue->is_stored(id))
      continue;
    try {
      const auto head = opened_.packs->head(id);
      auto known = opened_.catalogue->revision(id);
      if (!head || head->record.id != id || head->record.base == known->base) continue;
      known->base = head->record.base;
      known->bytes = opened_.packs->bytes_of(id);
      opened_.catalogue->apply({AddRevision{*known}});
      opened_.journal_behind = true;
    } catch (const Error& failure) {
      opened_.notes.push_back(id + " stays as it is: " + failure.what());
    }
  }
}

/// Whether a pack is an incomplete file that a crash left; its revision was never acknowledged. A
/// pack that has the mark of `is_being_written` but is whole loses the mark, and is used.
bool Opening::was_cut_off(const std::string& id) {
  const fs::path path = opened_.packs->path_of(id);
  if (!is_being_written(path)) return false;
  if (!opened_.packs->is_whole(id)) return true;
  try {
    settle_file(path);
  } catch (const Error& failure) {
    opened_.notes.emplace_back(failure.what());
  }
  return false;
}

void Opening::adopt_unknown_packs(Quarantine& quarantine) {
  std::vector<PackHead> found;
  Leftovers gone;
  for (const std::string& id : opened_.packs->list()) {
    if (opened_.catalogue->is_stored(id)) continue;
    const bool deleted = opened_.leftovers.contains(id);
    const fs::path path = opened_.packs->path_of(id);
    try {
      auto head = opened_.packs->head(id);
      const bool ours = head && head->record.id == id;
      if (deleted || was_cut_off(id)) {
        gone[id] = {.base = ours ? head->record.base : "", .bytes = opened_.packs->bytes_of(id)};
      } else if (!ours) {
        quarantine.take(path, "its head cannot be read");
      } else if (opened_.journal->intact() && !opened_.packs->is_whole(id)) {
        // Not deleted: the journal may be an older one.
        quarantine.take(path, "it is damaged, and the journal does not name it");
      } else {
        found.push_back(std::move(*head));
      }
    } catch (const Error& failure) {
      // What cannot be read now, the next opening may be able to read.
      if (deleted) gone[id].bytes = opened_.packs->bytes_of(id);
      opened_.notes.push_back(id + " stays as it is: " + failure.what());
    }
  }
  opened_.leftovers = std::move(gone);
  const auto by_number = [](const PackHead& a, const PackHead& b) {
    return std::tie(a.first.design, a.first.number, a.record.id) <
           std::tie(b.first.design, b.first.number, b.record.id);
  };
  std::sort(found.begin(), found.end(), by_number);
  std::map<std::string, std::string> heads;  // by design; a look-up would count all its revisions
  for (const PackHead& head : found) enter_again(head, heads);
  if (found.empty()) return;
  opened_.journal_behind = true;
  opened_.notes.push_back(std::to_string(found.size()) +
                          " revisions that the journal does not name were entered again");
}

/// Enters a revision that the journal does not know into the catalogue. `heads`: ids of the heads
/// of the designs met so far, by design.
void Opening::enter_again(const PackHead& head, std::map<std::string, std::string>& heads) {
  const std::string& design = head.first.design;
  Transaction adopt{AddRevision{head.record, head.recipe}};
  if (design.empty() || opened_.catalogue->revision(head.record.id)) {
    opened_.catalogue->apply(adopt);
    return;
  }
  const auto [now, fresh] = heads.try_emplace(design);
  if (const auto known = fresh ? opened_.catalogue->design(design) : std::nullopt)
    now->second = known->head;
  // A later line of the journal may have given it a place already.
  const auto places = opened_.catalogue->places(head.record.id);
  if (std::none_of(places.begin(), places.end(),
                   [&](const PlaceRecord& place) { return place.design == design; })) {
    const bool taken = opened_.catalogue->at(design, head.first.number).has_value();
    adopt.emplace_back(AddPlace{design,
                                taken ? opened_.catalogue->next_number(design) : head.first.number,
                                head.record.id});
  }
  // The head moves as the edit that made the revision moved it, unless that asked for something
  // else.
  if (now->second.empty() || now->second == head.record.parent) {
    adopt.emplace_back(SetHead{design, head.record.id});
    now->second = head.record.id;
  }
  opened_.catalogue->apply(adopt);
}

}  // namespace

std::vector<Transaction> lines_of(Catalogue& catalogue, const Leftovers& leftovers) {
  std::vector<Transaction> lines = catalogue.snapshot();
  for (const auto& [id, leftover] : leftovers)
    if (!catalogue.revision(id)) {
      lines.push_back({RemoveRevision{id}});
    } else if (!catalogue.is_stored(id)) {
      lines.push_back({DropMesh{id}});
    }
  return lines;
}

OpenedStore open_store(const fs::path& folder, double wait) {
  try {
    return Opening(folder, wait).take();
  } catch (const Error& failure) {
    ErrorInfo info = failure.info();
    if (info.message.find(folder.string()) == std::string::npos)
      info.message += " (store " + folder.string() + ")";
    throw Error(std::move(info));
  } catch (const fs::filesystem_error& failure) {
    throw error::store_failed("reading", folder.string(), failure.code().value());
  }
}

}  // namespace remeshd
