#include "server/store/store_format.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "engine/base/error.h"
#include "server/store/bare_store.h"
#include "server/store/checked_line.h"
#include "server/store/files.h"
#include "server/store/journal_line.h"
#include "server/store/json_number.h"
#include "server/store/pack_head.h"
#include "server/store/store_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr const char* kMark = "remeshd";

/// The start of a file; empty where the disk does not give it, which is no evidence.
std::string start_of(const fs::path& file) {
  try {
    return read_start(file, kMostHeadBytes);
  } catch (const Error&) {
    return {};
  }
}

std::optional<int> read_format(const fs::path& file) {
  if (!fs::is_regular_file(file)) return std::nullopt;
  const std::string start = start_of(file);
  const auto text = checked_text(start);
  if (!text) return std::nullopt;
  try {
    const json content = json::parse(*text);
    if (content.at("store") != kMark) return std::nullopt;
    return whole_number<int>(content.at("version"));
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

/// The newest version that a pack in the folder names; nothing where none does.
std::optional<int> version_of_packs(const fs::path& folder) {
  std::optional<int> newest;
  for (const char* name : {"packs", "objects"}) {
    if (!fs::is_directory(folder / name)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(
             folder / name, fs::directory_options::skip_permission_denied)) {
      if (!entry.is_regular_file()) continue;
      const auto version = store_version_of(start_of(entry.path()));
      if (version) newest = std::max(newest.value_or(0), *version);
    }
  }
  return newest;
}

bool has_journal(const fs::path& folder) {
  for (const char* name : {"journal.a", "journal.b", "journal"}) {
    if (!fs::is_regular_file(folder / name)) continue;
    const std::string text = read_whole(folder / name);
    for (std::size_t start = 0, end = 0; start < text.size(); start = end + 1) {
      end = std::min(text.find('\n', start), text.size());
      if (read_journal_line(std::string_view(text).substr(start, end - start))) return true;
    }
  }
  return false;
}

}  // namespace

FolderKind look_at_folder(const fs::path& folder) {
  try {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
      names.insert(entry.path().filename().string());
    names.erase("lost+found");
    if (is_empty_file(folder / "lock")) names.erase("lock");
    if (names.empty()) return FolderKind::Empty;
    if (const auto version = read_format(folder / "FORMAT")) {
      if (*version > kStoreVersion)
        throw error::store_newer(folder.string(), *version, kStoreVersion);
      return *version < kStoreVersion ? FolderKind::Older : FolderKind::Store;
    }
    if (const auto version = version_of_packs(folder)) {
      if (*version > kStoreVersion)
        throw error::store_newer(folder.string(), *version, kStoreVersion);
      return FolderKind::Unmarked;
    }
    if (has_journal(folder) || is_bare_store(folder)) return FolderKind::Unmarked;
    // An unreadable FORMAT is no evidence that the folder is somebody else's: this throws then.
    if (fs::is_regular_file(folder / "FORMAT")) read_start(folder / "FORMAT", kMostHeadBytes);
    throw error::store_foreign(folder.string(), *names.begin());
  } catch (const fs::filesystem_error& failure) {
    throw error::store_failed("reading", folder.string(), failure.code().value());
  }
}

std::string format_text(int version) {
  return checked_line(json{{"store", kMark}, {"version", version}}.dump());
}

void write_format(const fs::path& folder, const fs::path& scratch) {
  write_durably(folder / "FORMAT", format_text(kStoreVersion), scratch);
}

}  // namespace remeshd
