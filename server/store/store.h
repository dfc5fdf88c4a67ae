#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/catalogue.h"
#include "server/store/files.h"
#include "server/store/journal.h"
#include "server/store/objects.h"
#include "server/store/records.h"

namespace remeshd {

/// Revisions and designs, in a folder or in memory only.
///
/// A folder holds `objects/` (revisions, named by the hash of their bytes), `journal` (what
/// happened to the catalogue) and `index.sqlite`, which is made again from the journal, or the
/// journal itself from the objects, where it is missing or damaged. One process at a time has it.
/// Inv: what `commit` returned from survives a crash.
class Store {
 public:
  /// In memory only: holds the catalogue, no bytes.
  Store();
  /// Waits up to `wait` seconds for another process to let go.
  /// Throws Error: `StoreLocked`, `StoreFailed`.
  explicit Store(const std::filesystem::path& folder, double wait = 0);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  [[nodiscard]] bool persistent() const { return objects_ != nullptr; }
  /// What was mended or could not be used on opening; one line each.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  /// Writes a revision's bytes; `record` gets `object` and `bytes`. `first` is written beside them,
  /// for the case that the journal is lost.
  void put(RevisionRecord& record, const PlaceRecord& first, std::string_view bytes);
  /// The bytes of a revision. Throws Error(StoreCorrupted).
  std::string get(const RevisionRecord& record);

  /// Applies a transaction made by `make` from the catalogue as it stands, with nothing in between.
  /// An empty one changes nothing. Objects that no revision has any more are deleted.
  void commit(const std::function<Transaction(Catalogue&)>& make);
  /// Reads the catalogue with nothing in between.
  template <typename Read>
  auto read(Read&& reader) {
    const std::scoped_lock lock(mutex_);
    return reader(*catalogue_);
  }

 private:
  void lock_folder(double wait);
  void open_index(const std::filesystem::path& file);
  void adopt_objects();
  void drop_orphans();

  std::mutex mutex_;
  std::filesystem::path folder_;
  File lock_;
  std::unique_ptr<Objects> objects_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<Catalogue> catalogue_;
  std::vector<std::string> notes_;
};

}  // namespace remeshd
