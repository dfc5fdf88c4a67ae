#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace remeshd::test {

/// A call of this process that changed or opened a file, or a mark in between.
struct FileCall {
  enum class Kind { Create, Open, Write, Truncate, Sync, Rename, Unlink, MakeFolder, Mark };
  Kind kind = Kind::Mark;
  std::string path;      ///< relative to the recorded folder
  std::string to;        ///< Rename: the new name
  std::string data;      ///< Write
  std::uint64_t at = 0;  ///< Write: where in the file; Truncate: its new size; Mark: which one
  bool failed = false;   ///< told its caller so
};

/// What a folder held, and the calls that changed it since.
struct FileRecord {
  std::map<std::string, std::string> files;  ///< content by path
  std::vector<std::string> folders;          ///< outer ones first
  std::vector<FileCall> calls;
};

/// Records what this process does to the files below a folder, and makes calls fail. One at a time;
/// while there is none, files are as ever. It replaces `open`, `write`, `fsync`, `ftruncate`,
/// `rename`, `unlink` and `mkdir` of the program that it is linked into.
class FileCalls {
 public:
  explicit FileCalls(const std::filesystem::path& folder);
  ~FileCalls();
  FileCalls(const FileCalls&) = delete;
  FileCalls& operator=(const FileCalls&) = delete;

  /// What a call is to do: 0 for what it always does, else the error number that it fails with.
  /// A write that fails with a negative number has written half of its bytes before.
  using Decide = std::function<int(const FileCall&, std::size_t index)>;
  void decide(Decide decide);
  /// From now on, the opening of a file or folder that is there is a call too.
  void record_opening();
  /// Has `before` hear, once, that a file is about to be opened that is there.
  void before_opening(const std::string& path, std::function<void()> before);
  /// Has `before` hear, by its path, that a file is about to be synced. It may take its time:
  /// unlike `decide` it holds up no call but that one.
  void before_syncing(std::function<void(const std::string&)> before);
  void mark(std::uint64_t number);

  [[nodiscard]] FileRecord record() const;
};

/// A disk that lost power after the first `count` calls: what was not synced by then may be there
/// or not, in any combination that `keep` chooses; it is asked once for each change, in order. What
/// was written before a sync that failed stays such a change, whatever is synced later. Writes the
/// files below `folder`.
void write_after_power_cut(const FileRecord& record, std::size_t count,
                           const std::function<bool()>& keep, const std::filesystem::path& folder);

}  // namespace remeshd::test
