#pragma once

#include <filesystem>

namespace remeshd::cli {

/// Where `--local` keeps revisions where `--store` does not say: `$XDG_CACHE_HOME/remeshd` if that
/// variable is an absolute path, as the XDG rules demand, else `~/.cache/remeshd`.
///
/// Throws UsageError where there is no home either.
std::filesystem::path default_store_folder();

}  // namespace remeshd::cli
