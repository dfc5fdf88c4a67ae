#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "server/store/catalogue.h"
#include "server/store/files.h"
#include "server/store/journal.h"
#include "server/store/packs.h"
#include "server/store/records.h"

namespace remeshd {

/// The pack of a mesh that the catalogue does not have; its file may have been deleted already.
struct Leftover {
  std::string base;         ///< id of the pack's base; empty for none
  std::uint64_t bytes = 0;  ///< of the pack
};

/// Revisions whose mesh the catalogue does not have (removed, dropped or never added) and that may
/// still have a pack, by id.
using Leftovers = std::map<std::string, Leftover>;

/// What a store's folder holds, read and mended.
struct OpenedStore {
  File lock;  ///< held as long as the store is open
  std::unique_ptr<Packs> packs;
  std::unique_ptr<Journal> journal;
  std::unique_ptr<Catalogue> catalogue = std::make_unique<Catalogue>();
  bool journal_behind = false;  ///< the journal does not say what the catalogue says
  Leftovers leftovers;
  std::vector<std::filesystem::path> old_scratch;  ///< files that earlier processes were writing
  std::vector<std::string> notes;  ///< what was mended or could not be used; one line each
};

/// Opens the store in an absolute folder, which is made where it is missing. Deletes nothing: what
/// is not known goes to `quarantine/`. Waits up to `wait` seconds for another process to let go.
/// Throws Error: `STORE_FOREIGN`, `STORE_NEWER` (both change nothing in the folder),
/// `STORE_LOCKED`, `STORE_FAILED`, `STORE_FULL`.
OpenedStore open_store(const std::filesystem::path& folder, double wait);

/// The transactions of a rewritten journal: those of the catalogue, and the removals of the
/// leftovers.
std::vector<Transaction> lines_of(Catalogue& catalogue, const Leftovers& leftovers);

}  // namespace remeshd
