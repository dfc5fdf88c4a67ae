#include "server/store/packs.h"

#include <algorithm>

#include "engine/base/error.h"
#include "proto/checksum.h"
#include "server/store/files.h"
#include "server/store/store_error.h"

namespace remeshd {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kFolderDigits = 2;

/// Calls `visit` with each entry two levels down and the id that its place spells.
template <typename Visit>
void for_each_entry(const fs::path& folder, Visit&& visit) {
  for (const auto& outer : fs::directory_iterator(folder)) {
    const std::string prefix = outer.path().filename().string();
    if (!outer.is_directory() || prefix.size() != kFolderDigits) {
      visit(outer, std::string());
      continue;
    }
    for (const auto& inner : fs::directory_iterator(outer.path()))
      visit(inner, prefix + inner.path().filename().string());
  }
}

}  // namespace

bool is_full_id(std::string_view text) {
  return text.size() == 64 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

Packs::Packs(fs::path folder, fs::path scratch)
    : folder_(std::move(folder)), scratch_(std::move(scratch)) {}

fs::path Packs::path_of(const std::string& id) const {
  return folder_ / id.substr(0, kFolderDigits) / id.substr(kFolderDigits);
}

void Packs::make_folder_of(const std::string& id) {
  const std::string name = id.substr(0, kFolderDigits);
  const std::scoped_lock lock(mutex_);
  if (folders_.contains(name)) return;
  make_folder(folder_ / name);
  folders_.insert(name);
}

std::uint64_t Packs::put(const RevisionRecord& record, const PlaceRecord& first,
                         std::string_view bytes) {
  std::string file =
      write_pack_head({.record = record, .first = first, .sha256 = sha256_hex(bytes)});
  file += bytes;
  make_folder_of(record.id);
  write_durably(path_of(record.id), file, scratch_);
  return file.size();
}

std::string Packs::get(const RevisionRecord& record) const {
  const auto damaged = [&](const char* what) { return error::store_corrupted(record.id, what); };
  const fs::path path = path_of(record.id);
  if (!fs::exists(path)) throw damaged("it is gone");
  std::string file = read_whole(path);
  const auto head = read_pack_head(std::string_view(file).substr(0, kMostHeadBytes));
  if (!head) throw damaged("its head cannot be read");
  if (head->record.id != record.id) throw damaged("it is another revision");
  if (sha256_hex(std::string_view(file).substr(head->size)) != head->sha256)
    throw damaged("its content does not have its hash");
  file.erase(0, head->size);
  return file;
}

std::optional<PackHead> Packs::head(const std::string& id) const {
  const fs::path path = path_of(id);
  try {
    auto head = read_pack_head(read_start(path, kMostHeadBytes));
    if (!head) return std::nullopt;
    head->record.bytes = fs::file_size(path);
    return head;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void Packs::remove(const std::string& id) { remove_file(path_of(id)); }

std::vector<std::string> Packs::list() const {
  std::vector<std::string> ids;
  for_each_entry(folder_, [&](const fs::directory_entry& entry, const std::string& id) {
    if (is_full_id(id) && entry.is_regular_file()) ids.push_back(id);
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<fs::path> Packs::strangers() const {
  std::vector<fs::path> paths;
  for_each_entry(folder_, [&](const fs::directory_entry& entry, const std::string& id) {
    if (!is_full_id(id) || !entry.is_regular_file()) paths.push_back(entry.path());
  });
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace remeshd
