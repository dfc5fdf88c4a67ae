#include "server/tier/folder_objects.h"

#include <utility>

#include "server/limits.h"
#include "server/store/files.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

/// What `work` returns; its failures are the tier's.
template <typename Work>
auto as_tier(Work&& work) {
  try {
    return work();
  } catch (const Error& failure) {
    throw error::tier_unavailable(failure.info().message, limits::kTierRest.count());
  } catch (const fs::filesystem_error& failure) {
    throw error::tier_unavailable(failure.code().message(), limits::kTierRest.count());
  }
}

}  // namespace

FolderObjects::FolderObjects(fs::path folder) : folder_(std::move(folder)) {
  as_tier([&] { fs::create_directories(folder_ / "tmp"); });
}

bool FolderObjects::has(const std::string& key, double /*within*/) {
  return as_tier([&] { return fs::exists(folder_ / key); });
}

std::optional<std::string> FolderObjects::get(const std::string& key) {
  return as_tier([&]() -> std::optional<std::string> {
    if (!fs::exists(folder_ / key)) return std::nullopt;
    return read_whole(folder_ / key);
  });
}

void FolderObjects::put(const std::string& key, const std::string& bytes) {
  as_tier([&] {
    const fs::path file = folder_ / key;
    fs::create_directories(file.parent_path());
    write_durably(file, bytes, folder_ / "tmp");
  });
}

}  // namespace remeshd
