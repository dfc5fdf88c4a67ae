#include "server/store/objects.h"

#include <algorithm>
#include <system_error>

#include "proto/checksum.h"
#include "server/store/files.h"
#include "server/store/store_error.h"

namespace remeshd {
namespace fs = std::filesystem;

Objects::Objects(fs::path folder) : folder_(std::move(folder)), scratch_(folder_ / "tmp") {
  std::error_code failure;
  fs::remove_all(scratch_, failure);
  if (!failure) fs::create_directories(scratch_, failure);
  if (failure) throw error::store_failed("preparing", scratch_.string(), failure.value());
}

fs::path Objects::path_of(const std::string& hash) const {
  return folder_ / hash.substr(0, 2) / hash.substr(2);
}

std::string Objects::put(std::string_view bytes) {
  std::string hash = sha256_hex(bytes);
  const fs::path file = path_of(hash);
  // A damaged file of that name is written anew: this is how a store heals.
  if (fs::exists(file) && sha256_hex(read_whole(file)) == hash) return hash;
  std::error_code failure;
  if (fs::create_directories(file.parent_path(), failure)) sync_folder(folder_);
  if (failure) throw error::store_failed("making", file.parent_path().string(), failure.value());
  write_durably(file, bytes, scratch_);
  return hash;
}

std::string Objects::get(const std::string& hash) const {
  const fs::path file = path_of(hash);
  if (!fs::exists(file)) throw error::store_corrupted(file.string(), "it is gone");
  std::string bytes = read_whole(file);
  if (sha256_hex(bytes) != hash)
    throw error::store_corrupted(file.string(), "its content does not have its hash");
  return bytes;
}

void Objects::remove(const std::string& hash) {
  std::error_code failure;
  fs::remove(path_of(hash), failure);
  if (failure) throw error::store_failed("removing", path_of(hash).string(), failure.value());
}

std::vector<std::string> Objects::list() const {
  std::vector<std::string> hashes;
  for (const auto& folder : fs::directory_iterator(folder_)) {
    const std::string prefix = folder.path().filename();
    if (!folder.is_directory() || prefix.size() != 2) continue;
    for (const auto& file : fs::directory_iterator(folder.path()))
      hashes.push_back(prefix + file.path().filename().string());
  }
  std::sort(hashes.begin(), hashes.end());
  return hashes;
}

}  // namespace remeshd
