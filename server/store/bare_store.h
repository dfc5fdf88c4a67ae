#pragma once

#include <filesystem>

namespace remeshd {

/// Whether a folder is a store in which nothing was stored: what opening one makes, whole or in
/// part where a crash cut that off, of any version, and nothing of anybody else's. Only for a
/// folder that has no intact FORMAT, no pack and no line of a journal. Throws fs::filesystem_error;
/// Error.
bool is_bare_store(const std::filesystem::path& folder);

/// A regular file with nothing in it, and no link to one.
bool is_empty_file(const std::filesystem::path& file);

}  // namespace remeshd
