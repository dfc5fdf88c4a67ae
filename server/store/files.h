#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace remeshd {

/// An open file descriptor that closes itself.
class File {
 public:
  File() = default;
  /// Throws Error(StoreFailed). `flags` as of open(2); O_CLOEXEC is added.
  File(const std::filesystem::path& path, int flags);
  ~File();
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Writes all of it; throws Error(StoreFailed, StoreFull).
  void write(std::string_view bytes);
  /// Waits until what was written is on the disk.
  void sync();

 private:
  int descriptor_ = -1;
  std::filesystem::path path_;
};

/// Writes a file so that after a crash at any moment it is either absent or whole: temporary name
/// in `scratch` (on the same file system), fsync, rename, fsync of the folder.
/// Throws Error(StoreFailed, StoreFull).
void write_durably(const std::filesystem::path& file, std::string_view bytes,
                   const std::filesystem::path& scratch);

/// All of a file. Throws Error(StoreFailed).
std::string read_whole(const std::filesystem::path& file);

/// Waits until the names in a folder are on the disk.
void sync_folder(const std::filesystem::path& folder);

}  // namespace remeshd
