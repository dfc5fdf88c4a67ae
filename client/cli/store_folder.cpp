#include "client/cli/store_folder.h"

#include <cstdlib>

#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

std::filesystem::path absolute_path_in(const char* variable) {
  const char* value = std::getenv(variable);
  const std::filesystem::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : std::filesystem::path();
}

}  // namespace

std::filesystem::path default_store_folder() {
  if (const auto cache = absolute_path_in("XDG_CACHE_HOME"); !cache.empty())
    return cache / "remeshd";
  if (const auto home = absolute_path_in("HOME"); !home.empty()) return home / ".cache" / "remeshd";
  throw UsageError("--local needs --store, because there is no home folder to keep revisions in");
}

}  // namespace remeshd::cli
