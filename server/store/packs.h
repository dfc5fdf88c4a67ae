#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/pack_head.h"

namespace remeshd {

/// The bytes of revisions, a file each, `ab/cdef...` by the revision's id: a head, then the bytes.
/// A file that has its name is whole, but for what the disk did to it.
class Packs {
 public:
  /// `folder` and `scratch` must exist, on one file system.
  Packs(std::filesystem::path folder, std::filesystem::path scratch);

  /// Stores a revision, in place of what has its id. Returns the size of the file.
  /// Throws Error(STORE_FAILED, STORE_FULL); there may then be a pack or not.
  std::uint64_t put(const RevisionRecord& record, const PlaceRecord& first, std::string_view bytes);
  /// The bytes of a revision. Throws Error(STORE_CORRUPTED) where they are not what was stored, or
  /// gone; Error(STORE_FAILED).
  [[nodiscard]] std::string get(const RevisionRecord& record) const;
  /// What the file of a revision says of itself; nothing where that cannot be read.
  [[nodiscard]] std::optional<PackHead> head(const std::string& id) const;
  /// No error where there is none.
  void remove(const std::string& id);
  /// Ids of all files, sorted.
  [[nodiscard]] std::vector<std::string> list() const;
  /// What lies in the folder and is named otherwise.
  [[nodiscard]] std::vector<std::filesystem::path> strangers() const;
  [[nodiscard]] std::filesystem::path path_of(const std::string& id) const;

 private:
  void make_folder_of(const std::string& id);

  const std::filesystem::path folder_, scratch_;
  std::mutex mutex_;
  std::set<std::string> folders_;  ///< whose names are known to be on the disk
};

/// Whether a text is 64 lower-case hexadecimal digits.
bool is_full_id(std::string_view text);

}  // namespace remeshd
