#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace remeshd {

/// An open file descriptor that closes itself.
class File {
 public:
  File() = default;
  /// Throws Error(STORE_FAILED). `flags` as of open(2); O_CLOEXEC is added. A file that is made can
  /// be read by its owner only.
  File(const std::filesystem::path& path, int flags);
  ~File();
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Writes all of it; throws Error(STORE_FAILED, STORE_FULL).
  void write(std::string_view bytes);
  /// Waits until what was written is on the disk. After a failure nothing that was written since
  /// the last success may be believed to be there, even if a second call succeeds.
  void sync();
  /// Cuts the file off.
  void truncate(std::uint64_t size);

 private:
  int descriptor_ = -1;
  std::filesystem::path path_;
};

/// Writes a file so that after a crash at any moment it is either absent, as before or whole:
/// another name in `scratch` (on the same file system), fsync, rename, fsync of the folder. Where
/// it throws, nothing is left in `scratch`, and the file may have been replaced or not.
/// Throws Error(STORE_FAILED, STORE_FULL).
void write_durably(const std::filesystem::path& file, std::string_view bytes,
                   const std::filesystem::path& scratch);

/// All of a file. Throws Error(STORE_FAILED).
std::string read_whole(const std::filesystem::path& file);
/// What a file begins with, at most `limit` bytes. Throws Error(STORE_FAILED).
std::string read_start(const std::filesystem::path& file, std::size_t limit);

/// Makes a folder that may be there; its name is on the disk then. Throws Error(STORE_FAILED).
void make_folder(const std::filesystem::path& folder);
/// Waits until the names in a folder are on the disk.
void sync_folder(const std::filesystem::path& folder);
/// Gives a file, or a folder, another name on the same file system. Throws Error(STORE_FAILED).
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);
/// Removes a file; no error where there is none. Throws Error(STORE_FAILED).
void remove_file(const std::filesystem::path& file);

}  // namespace remeshd
