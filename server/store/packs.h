#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/stored_array.h"
#include "server/store/pack_head.h"

namespace remeshd {

/// The arrays of revisions, a file each, `ab/cdef...` by the revision's id: a head, then the
/// arrays, most of them as differences to those of another pack, its base, whose file has to stay
/// as long. Packs of store version 1 and before have one array, `kOlderBytes`, and are no base.
///
/// A new file is written at its place: after a crash it may be there in part, which `is_whole`
/// tells. A file that is replaced is as before or whole after a crash.
class Packs {
 public:
  /// A revision that another one's arrays may be encoded against.
  struct Base {
    std::string id;
    const StoredArrays* arrays;
  };
  /// What is known of a pack without decoding it.
  struct Written {
    std::uint64_t bytes = 0;  ///< of the file
    std::string base;         ///< id of the base taken; empty for none
  };

  /// `folder` and `scratch` must exist, on one file system.
  Packs(std::filesystem::path folder, std::filesystem::path scratch);

  /// Stores a revision, in place of what has its id. A base that has no pack, a damaged one, or one
  /// with so long a chain of bases that reading it would take long, is not used.
  /// The file's time of last change is the record's `created_ns`. One revision may not be put twice
  /// at a time.
  /// Throws Error(STORE_FAILED, STORE_FULL); there may then be a pack or not.
  /// `recipe`: as `packed`; may be empty.
  Written put(const RevisionRecord& record, const PlaceRecord& first, const std::string& recipe,
              const StoredArrays& arrays, const Base* base);
  /// Stores a pack file of another store of this version, in place of what has its id. Its base
  /// must be here. One revision may not be put twice at a time. Throws Error(STORE_CORRUPTED) where
  /// it is damaged, of another revision, or its base is not here or another one; STORE_FAILED,
  /// STORE_FULL.
  Written take_in(const RevisionRecord& record, std::string_view file);
  /// The file of a revision, whole. Throws Error(STORE_CORRUPTED, STORE_FAILED).
  [[nodiscard]] std::string file(const std::string& id) const;
  /// The head of a pack file of this version; nothing where it is no such file.
  [[nodiscard]] static std::optional<PackHead> head_in(std::string_view file);
  /// The arrays of a revision. Throws Error(STORE_CORRUPTED) where they are not what was stored, or
  /// gone, or a base of theirs is; Error(STORE_FAILED).
  [[nodiscard]] StoredArrays get(const std::string& id);
  /// The head of a revision's file, with `created_ns` from the file's time of last change; nothing
  /// where there is no file or no readable head. Throws Error(STORE_FAILED).
  [[nodiscard]] std::optional<PackHead> head(const std::string& id) const;
  /// Bytes of a revision's file; 0 where there is none.
  [[nodiscard]] std::uint64_t bytes_of(const std::string& id) const;
  /// Whether a file has all bytes that its head tells of, undamaged. Bases are not looked at.
  /// Throws Error(STORE_FAILED).
  [[nodiscard]] bool is_whole(const std::string& id) const;
  /// What is wrong with a file, or, by its head, with its base; else empty.
  [[nodiscard]] std::string fault_of(const std::string& id) const;
  /// No error where there is none.
  void remove(const std::string& id);

  /// Ids of all files, sorted.
  [[nodiscard]] std::vector<std::string> list() const;
  /// Everything in the folder but the files of `list`.
  [[nodiscard]] std::vector<std::filesystem::path> strangers() const;
  [[nodiscard]] std::filesystem::path path_of(const std::string& id) const;

 private:
  /// What encoding against a pack needs beside its arrays.
  struct State {
    std::string content;
    std::uint32_t chain = 1;
    std::uint64_t chain_bytes = 0, full_bytes = 0;
    std::map<std::string, PageDepths> depths;  ///< by array
  };
  using StatePtr = std::shared_ptr<const State>;
  struct File {
    PackHead head;
    std::string bytes;
  };
  struct Decoded {
    StatePtr state;
    std::map<std::string, DecodedArray> arrays;
    std::vector<std::string> names;  ///< of the arrays, in their order
  };

  static File checked(const std::string& id, std::string bytes);
  [[nodiscard]] File read_file(const std::string& id) const;
  [[nodiscard]] Decoded decode_chain(const std::string& id) const;
  StatePtr state_of(const std::string& id);
  StatePtr usable_state(const Base& base);
  void remember(const std::string& id, StatePtr state);
  void write(const RevisionRecord& record, std::string_view file);

  const std::filesystem::path folder_, scratch_;
  std::mutex mutex_;
  std::set<std::string> folders_;                       ///< whose names are known to be on the disk
  std::list<std::pair<std::string, StatePtr>> states_;  ///< of packs used last, the latest first
};

/// Whether a text is 64 lower-case hexadecimal digits.
bool is_full_id(std::string_view text);

}  // namespace remeshd
