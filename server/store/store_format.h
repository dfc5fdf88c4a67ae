#pragma once

#include <filesystem>
#include <string>

namespace remeshd {

/// Version of the layout of stores that this program writes. 1: packs hold the bytes of a revision
/// in one piece. 2: as arrays, most of them as differences to those of another pack.
inline constexpr int kStoreVersion = 2;
inline constexpr int kFirstWithArrays = 2;

/// What a folder is in which a store is to be opened.
enum class FolderKind {
  Empty,     ///< a store may be made there
  Store,     ///< of this version, with an intact FORMAT
  Older,     ///< of an older version, with an intact FORMAT
  Unmarked,  ///< a store of this version or an older one, whose FORMAT is missing or damaged
};

/// Looks at a folder, and changes nothing there. FORMAT decides where it is intact; else the heads
/// of the packs do, then what else there is.
///
/// Throws Error: `STORE_FOREIGN` for a folder that holds something else, `STORE_NEWER` for a store
/// of a newer version, `STORE_FAILED`.
FolderKind look_at_folder(const std::filesystem::path& folder);

/// What FORMAT holds in a store of that version.
std::string format_text(int version);

/// Writes FORMAT. Throws Error(STORE_FAILED, STORE_FULL).
void write_format(const std::filesystem::path& folder, const std::filesystem::path& scratch);

}  // namespace remeshd
