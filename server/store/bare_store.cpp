#include "server/store/bare_store.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "engine/base/error.h"
#include "server/store/files.h"
#include "server/store/pack_head.h"
#include "server/store/store_format.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

// The first layout's index has this table, in its file or still in the write-ahead log.
constexpr std::string_view kIndexTable =
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID";
constexpr std::array<std::string_view, 3> kIndex{"index.sqlite", "index.sqlite-wal",
                                                 "index.sqlite-shm"};

bool is_plain_file(const fs::path& file) { return fs::is_regular_file(fs::symlink_status(file)); }

/// Whether everything below a folder that is not itself a folder fits; false if `folder` is not a
/// folder.
template <typename Fits>
bool all_below(const fs::path& folder, Fits&& fits) {
  if (!fs::is_directory(folder)) return false;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if ((entry.is_symlink() || !entry.is_directory()) && !fits(entry.path())) return false;
  return true;
}

bool has_no_files(const fs::path& folder) {
  return all_below(folder, [](const fs::path&) { return false; });
}

/// Whether the two folders exist that opening a store makes before it writes FORMAT.
bool has_what_format_needs(const fs::path& folder) {
  return fs::is_directory(folder / "tmp") && fs::is_directory(folder / "packs");
}

/// Whether a scratch file is a FORMAT that a crash kept from being renamed, with all of its bytes
/// on the disk or only some.
bool is_format_being_written(const fs::path& file) {
  if (!is_scratch_name(file.filename().string()) || !is_plain_file(file)) return false;
  const std::string bytes = read_start(file, kMostHeadBytes);
  for (int version = 1; version <= kStoreVersion; ++version) {
    const std::string whole = format_text(version);
    if (bytes.size() > whole.size()) continue;
    if (std::equal(bytes.begin(), bytes.end(), whole.begin(),
                   [](char there, char written) { return there == written || there == 0; }))
      return true;
  }
  return false;
}

/// Whether a file in the quarantine is a damaged FORMAT, which opening moves there before it writes
/// another one.
bool is_format_put_away(const fs::path& file) {
  return is_plain_file(file) && file.filename().string().find("-FORMAT") != std::string::npos;
}

bool has_stores_only(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_directory()) return false;
    try {
      look_at_folder(entry.path());
    } catch (const Error& failure) {
      if (failure.info().reason != "STORE_FOREIGN") throw;
      return false;
    }
  }
  return true;
}

/// Whether the files of an SQLite database are the first layout's index.
bool has_index(const fs::path& folder) {
  bool ours = false;
  for (const std::string_view name : kIndex) {
    const fs::path file = folder / name;
    if (!fs::exists(fs::symlink_status(file))) continue;
    if (!is_plain_file(file)) return false;
    ours |= read_start(file, kMostHeadBytes).find(kIndexTable) != std::string::npos;
  }
  return ours && fs::is_directory(folder / "objects");
}

/// Whether an entry of a folder is what an empty store has under that name.
bool is_ours(const fs::path& path) {
  const std::string name = path.filename().string();
  const fs::path folder = path.parent_path();
  if (name == "lock" || name == "journal" || name == "journal.a" || name == "journal.b")
    return is_empty_file(path);
  if (name == "packs" || name == "objects") return has_no_files(path);
  if (name == "FORMAT")
    return has_what_format_needs(folder) && (!fs::is_directory(path) || has_no_files(path));
  if (name == "tmp")
    return has_no_files(path) ||
           (has_what_format_needs(folder) && all_below(path, is_format_being_written));
  if (name == "quarantine")
    return has_no_files(path) ||
           (has_what_format_needs(folder) && all_below(path, is_format_put_away));
  if (name == "tenants") return fs::is_directory(path) && has_stores_only(path);
  if (std::ranges::find(kIndex, name) != kIndex.end()) return has_index(folder);
  return name == "lost+found";  // a file system's
}

}  // namespace

bool is_empty_file(const fs::path& file) { return is_plain_file(file) && fs::file_size(file) == 0; }

bool is_bare_store(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (!is_ours(entry.path())) return false;
  return true;
}

}  // namespace remeshd
