#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/store/catalogue.h"
#include "server/store/files.h"
#include "server/store/journal.h"
#include "server/store/opening.h"
#include "server/store/packs.h"
#include "server/store/records.h"

namespace remeshd {

/// Revisions and designs, in a folder or in memory only.
///
/// A folder holds `FORMAT` (what it is, and of which version), `packs/` (the bytes of revisions),
/// `journal.a` and `journal.b` (what happened to the catalogue, twice), `tmp/` (files being
/// written), `quarantine/` (what was found and is not known) and `lock`: one process at a time has
/// the store. `tenants/` may be there too, with stores of their own. The catalogue itself is in
/// memory, made from the journal; what the journal lost is made from the heads of the packs.
///
/// Inv: a transaction for which `commit` returned true survives a crash. Opening deletes nothing;
/// the first commit after it deletes files that an earlier process left half-written, and packs of
/// revisions that the catalogue no longer has.
class Store {
 public:
  /// In memory only: holds the catalogue, no bytes.
  Store();
  /// Waits up to `wait` seconds for another process to let go.
  /// Throws Error: `STORE_FOREIGN`, `STORE_NEWER` (both change nothing in the folder),
  /// `STORE_LOCKED`, `STORE_FAILED`, `STORE_FULL`.
  explicit Store(const std::filesystem::path& folder, double wait = 0);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  [[nodiscard]] bool persistent() const { return packs_ != nullptr; }
  /// What was mended or could not be used on opening; one line each.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  /// Writes a revision's arrays, in place of those that are there; `record` gets `bytes` and
  /// `base`. `base`: a revision that they may be encoded against; null for none. `first` is written
  /// beside them, for the case that the journal is lost.
  ///
  /// The pack and its base stay until a commit adds the revision, fails to, or `discard` gives the
  /// pack up. Waits for the disk; other calls do not wait for this one. A revision may not be put
  /// twice at a time. Throws Error(STORE_FAILED, STORE_FULL); then the pack is given up.
  ///
  /// `recipe`: text, maybe empty, that the revision can be remade from; stored beside the arrays,
  /// and again by the transaction that adds the revision.
  void put(RevisionRecord& record, const PlaceRecord& first, const std::string& recipe,
           const StoredArrays& arrays, const Packs::Base* base = nullptr);
  /// The same for a pack file of another store, as Packs::take_in. Pre: the store is persistent.
  void take_in(RevisionRecord& record, std::string_view pack);
  /// Gives up what was put and not committed.
  void discard(const std::string& id);
  /// The arrays of a revision. Throws Error(STORE_CORRUPTED, STORE_FAILED).
  StoredArrays get(const std::string& id);
  /// The pack of a revision, whole, for another store. Throws Error(STORE_CORRUPTED, STORE_FAILED).
  std::string pack(const std::string& id);
  /// What is wrong with the file of a revision; else empty. Pre: the store is persistent.
  [[nodiscard]] std::string fault_of(const std::string& id) const;
  /// Bytes of all packs, those too of removed revisions and dropped meshes that others stand on.
  [[nodiscard]] std::uint64_t bytes();
  /// The base of a pack, even of one that others alone need; empty for none.
  std::string base_of(const std::string& id);
  /// Pairs (revision, base): the base is the pack of a removed revision or dropped mesh, and that
  /// revision's pack is the only one encoded against it. Once the revision is stored against
  /// another base, or none, the base's pack can be deleted.
  std::vector<std::pair<std::string, std::string>> on_removed_bases();
  /// The recipe of a revision, even of one whose mesh has gone or that was deleted: from the
  /// journal, else from its pack. Empty where there is none. Waits for the disk. Throws
  /// Error(STORE_FAILED, STORE_CORRUPTED).
  std::string recipe(const std::string& id);
  /// Free space of the file system, and what the quarantine holds.
  struct Room {
    std::uint64_t free_bytes = 0;
    std::uint32_t quarantined = 0;  ///< files
  };
  [[nodiscard]] Room room() const;
  /// Puts bytes of another store that are refused into the quarantine; returns a clause that tells
  /// where, and why. Pre: the store is persistent.
  std::string quarantine(std::string_view name, std::string_view bytes, std::string_view why);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// A recipe as a transaction has it.
  static std::string packed_recipe(const std::string& recipe);

  /// Applies the transaction that `make` makes of the catalogue, with no other commit in between.
  /// An empty one changes nothing. The packs of removed revisions and dropped meshes are deleted
  /// once no other pack needs them; where this throws, so are those of revisions that it would have
  /// added.
  ///
  /// `GoOn`: on a full disk the catalogue in memory takes the transaction all the same, the packs
  /// of what it removes are deleted to make room for its line, and where that is not enough, the
  /// journal takes it with the next commit or `flush` that finds room. Returns false then.
  enum class OnFullDisk { Throw, GoOn };
  bool commit(const std::function<Transaction(Catalogue&)>& make,
              OnFullDisk on_full_disk = OnFullDisk::Throw);
  /// Writes what the journal lacks. Throws Error(STORE_FAILED, STORE_FULL).
  void flush();
  /// Where the store is not healthy, finds out by a trial file whether it is again. Throws
  /// Error(STORE_FAILED, STORE_FULL).
  void try_disk();
  /// False after a write failed, until a pack or a trial file has been written, or a line of the
  /// journal for which packs were deleted.
  [[nodiscard]] bool healthy() const { return healthy_; }
  /// Calls `listener` with `healthy()` now and at every change. It must not call back; empty:
  /// nobody.
  void on_health(std::function<void(bool healthy)> listener);
  /// Calls `listener` when the store ceases to be healthy, or now if it is not: the listener has to
  /// see to it that `flush` and `try_disk` are called until both succeed. It must not call back;
  /// empty: nobody.
  void on_failure(std::function<void()> listener);
  /// Calls `reader` with the catalogue, with no change in between. Never waits for the disk.
  template <typename Read>
  auto read(Read&& reader) {
    const std::scoped_lock lock(reading_);
    return reader(*catalogue_);
  }

 private:
  Store(std::filesystem::path folder, OpenedStore opened);
  void put_with(RevisionRecord& record, const std::string& base,
                const std::function<Packs::Written()>& write);
  void apply(const Transaction& transaction);
  void enter(Transaction& transaction);
  void rewrite_journal(const Transaction& last);
  void drop_added(const Transaction& transaction);
  void count_leftovers();
  std::string packed_recipe_of(const std::string& id);
  bool enter_in_room_of(const Leftovers& removed, const Transaction& transaction);
  void tidy();
  /// Deletes the packs of leftovers for which `which` holds and that nothing needs.
  void delete_packs(const std::function<bool(const std::string& id)>& which);
  void set_healthy(bool healthy);

  // A change holds `committing_` all along, also while it waits for the disk, and `reading_` only
  // while it works on memory. Always locked in this order.
  std::mutex committing_;
  std::mutex reading_;  ///< guards the catalogue
  std::filesystem::path folder_;
  File lock_;
  std::unique_ptr<Packs> packs_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<Catalogue> catalogue_;

  std::mutex health_;  ///< guards the listeners
  std::function<void(bool)> health_listener_;
  std::function<void()> failure_listener_;
  std::atomic<bool> healthy_ = true;
  std::atomic<std::uint64_t> deletions_ = 0;  ///< of packs, counted before they are deleted
  std::uint64_t many_lines_ = 0;              ///< beyond which the journal may have too many
  bool journal_behind_ = false;               ///< the journal does not say what the catalogue says
  Leftovers leftovers_;
  std::atomic<std::uint64_t> leftover_bytes_ = 0;  ///< theirs, for who may not wait for the disk
  std::map<std::string, std::string>
      unfiled_;  ///< put and not committed: with the base it may have
  std::vector<std::filesystem::path> old_scratch_;  ///< of earlier processes
  std::vector<std::string> notes_;
};

}  // namespace remeshd
