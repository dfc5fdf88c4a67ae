#pragma once

#include <filesystem>

namespace remeshd {

/// Whether a folder holds only what the opening of an empty store makes, of any version, complete
/// or cut off by a crash, and nothing else. Pre: the folder has no intact FORMAT, no pack and no
/// line of a journal. Throws fs::filesystem_error; Error.
bool is_bare_store(const std::filesystem::path& folder);

/// Whether it is a regular file of no bytes, and not a link to one.
bool is_empty_file(const std::filesystem::path& file);

}  // namespace remeshd
