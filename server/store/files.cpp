#include "server/store/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "server/store/store_error.h"

namespace remeshd {

File::File(const std::filesystem::path& path, int flags)
    : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0644)), path_(path) {
  if (descriptor_ < 0) throw error::store_failed("opening", path.string(), errno);
}
File::~File() {
  if (descriptor_ >= 0) ::close(descriptor_);
}
File::File(File&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}
File& File::operator=(File&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  return *this;
}

void File::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw error::store_failed("writing", path_.string(), errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void File::sync() {
  if (::fsync(descriptor_) != 0) throw error::store_failed("syncing", path_.string(), errno);
}

void sync_folder(const std::filesystem::path& folder) {
  File(folder, O_RDONLY | O_DIRECTORY).sync();
}

void write_durably(const std::filesystem::path& file, std::string_view bytes,
                   const std::filesystem::path& scratch) {
  static std::atomic<unsigned> counter{0};
  const std::filesystem::path temporary =
      scratch / (std::to_string(::getpid()) + "-" + std::to_string(counter++));
  try {
    File out(temporary, O_WRONLY | O_CREAT | O_EXCL);
    out.write(bytes);
    out.sync();
    if (std::rename(temporary.c_str(), file.c_str()) != 0)
      throw error::store_failed("renaming", file.string(), errno);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(file.parent_path());
}

std::string read_whole(const std::filesystem::path& file) {
  const File in(file, O_RDONLY);
  std::error_code failure;
  std::string bytes(static_cast<std::size_t>(std::filesystem::file_size(file, failure)), '\0');
  if (failure) throw error::store_failed("measuring", file.string(), failure.value());
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(in.descriptor(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw error::store_failed("reading", file.string(), errno);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace remeshd
