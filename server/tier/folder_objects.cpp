#include "server/tier/folder_objects.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "server/limits.h"
#include "server/store/files.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

constexpr const char* kMark = "TIER";
constexpr const char* kScratch = "tmp";

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
  as_tier([&] {
    fs::create_directories(folder_ / kScratch);
    if (fs::exists(folder_ / kMark)) return;
    const auto strange = [](const auto& entry) { return entry.path().filename() != kScratch; };
    const fs::directory_iterator entries(folder_);
    begun_ = std::none_of(begin(entries), end(entries), strange);
    write_durably(folder_ / kMark, "A tier of remeshd. Without this file it takes no objects.\n",
                  folder_ / kScratch);
  });
}

template <typename Work>
auto FolderObjects::with_tier(Work&& work) {
  if (!as_tier([&] { return fs::exists(folder_ / kMark); }))
    throw error::tier_unavailable(
        folder_.string() + " has no file " + kMark + "; is its file system mounted?",
        limits::kTierRest.count());
  return as_tier(work);
}

bool FolderObjects::has(const std::string& key, double /*within*/) {
  return with_tier([&] { return fs::exists(folder_ / key); });
}

std::optional<std::string> FolderObjects::get(const std::string& key,
                                              const std::stop_token& /*stop*/) {
  return with_tier([&]() -> std::optional<std::string> {
    if (!fs::exists(folder_ / key)) return std::nullopt;
    return read_whole(folder_ / key);
  });
}

void FolderObjects::put(const std::string& key, const std::string& bytes) {
  with_tier([&] {
    const fs::path file = folder_ / key;
    fs::create_directories(file.parent_path());
    write_durably(file, bytes, folder_ / kScratch);
  });
}

std::optional<std::string> FolderObjects::start_of(const std::string& key, std::size_t bytes) {
  return with_tier([&]() -> std::optional<std::string> {
    if (!fs::exists(folder_ / key)) return std::nullopt;
    return read_start(folder_ / key, bytes);
  });
}

void FolderObjects::list(const std::string& prefix,
                         const std::function<void(const ObjectInfo&)>& visit) {
  with_tier([&] {
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
  with_tier([&] { remove_file(folder_ / key); });
}

}  // namespace remeshd
