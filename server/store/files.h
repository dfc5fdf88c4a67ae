#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// An open file descriptor that closes itself.
class File {
 public:
  File() = default;
  /// Throws Error(STORE_FAILED). `flags` as of open(2); O_CLOEXEC is added. A file that is made can
  /// be read by its owner only.
  File(const std::filesystem::path& path, int flags, unsigned mode = 0600);
  ~File();
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Writes all of it; throws Error(STORE_FAILED, STORE_FULL).
  void write(std::string_view bytes);
  /// Waits until what was written is on the disk. After a failure nothing that was written since
  /// the last success may be believed to be there, even if a second call succeeds.
  void sync() const;
  /// What stands at `start`, at most `length` bytes; fewer at the end of the file. Throws
  /// Error(STORE_FAILED).
  [[nodiscard]] std::string read(std::uint64_t start, std::size_t length) const;
  /// Sets the time of the last change, in ns since 1970.
  void set_time(std::int64_t time_ns);
  /// Sets who may read and write it.
  void set_mode(unsigned mode);
  /// Cuts the file off.
  void truncate(std::uint64_t size);

 private:
  int descriptor_ = -1;
  std::filesystem::path path_;
};

/// Writes a file so that after a crash at any moment it is either absent, as before or whole:
/// another name in `scratch` (on the same file system), fsync, rename, fsync of the folder. Where
/// it throws, nothing is left in `scratch`, and the file may have been replaced or not. `time_ns`:
/// as `write_in_place`. Throws Error(STORE_FAILED, STORE_FULL).
void write_durably(const std::filesystem::path& file, std::string_view bytes,
                   const std::filesystem::path& scratch,
                   std::optional<std::int64_t> time_ns = std::nullopt);
/// The same for what `write` writes, piece by piece.
void write_durably(const std::filesystem::path& file, const std::function<void(File&)>& write,
                   const std::filesystem::path& scratch,
                   std::optional<std::int64_t> time_ns = std::nullopt);

/// Writes so many bytes to a file in `scratch`, waits for the disk and removes it again. Throws
/// Error(STORE_FAILED, STORE_FULL) where that does not work.
void try_writing(std::size_t bytes, const std::filesystem::path& scratch);

/// Whether a name may be one that the functions above give a file in `scratch`, in this version or
/// earlier ones.
bool is_scratch_name(std::string_view name);

/// Writes a new file directly at its place, with `time_ns` (since 1970) for the time of its last
/// change. The file and `folders`, which have new names in them, are synced at the same time. A
/// crash before the return may leave any part of the file; until all of it is written it has the
/// mark of `is_being_written`, which is never on the disk after the return. Where this throws, the
/// file is removed, and what the disk has of it is not to be trusted. Throws Error(STORE_FAILED,
/// STORE_FULL).
void write_in_place(const std::filesystem::path& file, std::string_view bytes, std::int64_t time_ns,
                    const std::vector<std::filesystem::path>& folders);

/// Whether a file has the mark of one that `write_in_place` has not written whole: not even its
/// owner may write to it. False where that cannot be told.
bool is_being_written(const std::filesystem::path& file);
/// Takes that mark off a file that is whole all the same, and waits for the disk. Throws
/// Error(STORE_FAILED).
void settle_file(const std::filesystem::path& file);

/// When a file's content, name or attributes changed last, ns since 1970: unlike the time of its
/// last change, which `write_in_place` sets, nothing but the system sets this (ctime). 0 where
/// there is no file.
std::int64_t changed_ns(const std::filesystem::path& file);

/// All of a file. Throws Error(STORE_FAILED).
std::string read_whole(const std::filesystem::path& file);
/// What a file begins with, at most `limit` bytes. Throws Error(STORE_FAILED).
std::string read_start(const std::filesystem::path& file, std::size_t limit);

/// Makes a folder, unless it is there, and waits until its name is on the disk. Throws
/// Error(STORE_FAILED).
void make_folder(const std::filesystem::path& folder);
/// The same without waiting for the disk.
void make_unsynced_folder(const std::filesystem::path& folder);
/// Waits until the names in a folder are on the disk.
void sync_folder(const std::filesystem::path& folder);
/// Gives a file, or a folder, another name on the same file system. Throws Error(STORE_FAILED).
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);
/// Removes a file; no error where there is none. Throws Error(STORE_FAILED).
void remove_file(const std::filesystem::path& file);

}  // namespace remeshd
