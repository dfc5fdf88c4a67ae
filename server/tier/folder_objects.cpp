#include "server/tier/folder_objects.h"

#include <chrono>
#include <utility>

#include "server/limits.h"
#include "server/store/files.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

/// Returns what `work` does; its failures become TIER_UNAVAILABLE.
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

std::optional<std::string> FolderObjects::start_of(const std::string& key, std::size_t bytes) {
  return as_tier([&]() -> std::optional<std::string> {
    if (!fs::exists(folder_ / key)) return std::nullopt;
    return read_start(folder_ / key, bytes);
  });
}

void FolderObjects::list(const std::string& prefix,
                         const std::function<void(const ObjectInfo&)>& visit) {
  as_tier([&] {
    if (!fs::exists(folder_ / prefix)) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / prefix)) {
      if (!entry.is_regular_file()) continue;
      const auto written = std::chrono::file_clock::to_sys(entry.last_write_time());
      visit({.key = entry.path().lexically_relative(folder_).generic_string(),
             .bytes = entry.file_size(),
             .written_ns = std::chrono::nanoseconds(written.time_since_epoch()).count()});
    }
  });
}

void FolderObjects::remove(const std::string& key) {
  as_tier([&] { remove_file(folder_ / key); });
}

}  // namespace remeshd
