#include "server/store/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <future>
#include <random>
#include <system_error>
#include <utility>

#include "server/store/store_error.h"

namespace remeshd {
namespace {

constexpr unsigned kMode = 0600;
constexpr unsigned kModeWhileWritten = 0400;  // the open descriptor may write all the same

}  // namespace

File::File(const std::filesystem::path& path, int flags, unsigned mode)
    : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, mode)), path_(path) {
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

void File::sync() const {
  if (::fsync(descriptor_) != 0) throw error::store_failed("syncing", path_.string(), errno);
}

std::string File::read(std::uint64_t start, std::size_t length) const {
  std::string bytes(length, '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                static_cast<off_t>(start + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw error::store_failed("reading", path_.string(), errno);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

void File::set_time(std::int64_t time_ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const timespec time{.tv_sec = time_ns / kSecond, .tv_nsec = time_ns % kSecond};
  const timespec times[] = {time, time};
  if (::futimens(descriptor_, times) != 0)
    throw error::store_failed("dating", path_.string(), errno);
}

void File::set_mode(unsigned mode) {
  if (::fchmod(descriptor_, mode) != 0)
    throw error::store_failed("setting the mode of", path_.string(), errno);
}

void File::truncate(std::uint64_t size) {
  if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0)
    throw error::store_failed("cutting off", path_.string(), errno);
}

void make_unsynced_folder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0 &&
      !(errno == EEXIST && std::filesystem::is_directory(folder)))
    throw error::store_failed("making", folder.string(), errno);
}

void make_folder(const std::filesystem::path& folder) {
  make_unsynced_folder(folder);
  // Also for a folder that is there: a crash may have come before its name was on the disk.
  sync_folder(folder.parent_path());
}

void sync_folder(const std::filesystem::path& folder) {
  File(folder, O_RDONLY | O_DIRECTORY).sync();
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0)
    throw error::store_failed("renaming", from.string(), errno);
}

void remove_file(const std::filesystem::path& file) {
  if (::unlink(file.c_str()) != 0 && errno != ENOENT)
    throw error::store_failed("removing", file.string(), errno);
}

namespace {

/// A name that no file in `scratch` has.
std::filesystem::path scratch_file(const std::filesystem::path& scratch) {
  // An earlier process that left files there may have had the same process id.
  static const std::string process =
      std::to_string(::getpid()) + "-" + std::to_string(std::random_device{}());
  static std::atomic<unsigned> counter{0};
  return scratch / (process + "-" + std::to_string(counter++));
}

}  // namespace

void write_durably(const std::filesystem::path& file, std::string_view bytes,
                   const std::filesystem::path& scratch, std::optional<std::int64_t> time_ns) {
  write_durably(
      file, [&](File& out) { out.write(bytes); }, scratch, time_ns);
}

void write_durably(const std::filesystem::path& file, const std::function<void(File&)>& write,
                   const std::filesystem::path& scratch, std::optional<std::int64_t> time_ns) {
  const std::filesystem::path temporary = scratch_file(scratch);
  try {
    File out(temporary, O_WRONLY | O_CREAT | O_EXCL);
    write(out);
    if (time_ns) out.set_time(*time_ns);
    out.sync();
    rename_file(temporary, file);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(file.parent_path());
}

void try_writing(std::size_t bytes, const std::filesystem::path& scratch) {
  const std::filesystem::path temporary = scratch_file(scratch);
  try {
    File out(temporary, O_WRONLY | O_CREAT | O_EXCL);
    out.write(std::string(bytes, 'x'));
    out.sync();
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  remove_file(temporary);
}

bool is_scratch_name(std::string_view name) {
  // Two numbers or three: earlier versions went without the random one.
  const auto is_number = [](std::string_view text) {
    return !text.empty() && (text == "0" || text.front() != '0') &&
           std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  };
  std::size_t numbers = 0;
  for (;;) {
    const std::size_t end = std::min(name.find('-'), name.size());
    if (!is_number(name.substr(0, end))) return false;
    ++numbers;
    if (end == name.size()) return numbers == 2 || numbers == 3;
    name.remove_prefix(end + 1);
  }
}

void write_in_place(const std::filesystem::path& file, std::string_view bytes, std::int64_t time_ns,
                    const std::vector<std::filesystem::path>& folders) {
  File out(file, O_WRONLY | O_CREAT | O_EXCL, kModeWhileWritten);
  try {
    out.write(bytes);
    out.set_time(time_ns);
    out.set_mode(kMode);
    // At the same time: one after the other they would take the sum of their times.
    std::vector<std::future<void>> others;
    for (const std::filesystem::path& folder : folders)
      others.push_back(std::async(std::launch::async, [&folder] { sync_folder(folder); }));
    out.sync();
    for (std::future<void>& other : others) other.get();
  } catch (const std::system_error&) {
    ::unlink(file.c_str());
    throw error::store_failed("syncing", file.string(), EAGAIN);  // no thread to be had
  } catch (...) {
    ::unlink(file.c_str());
    throw;
  }
}

bool is_being_written(const std::filesystem::path& file) {
  struct stat status {};
  return ::lstat(file.c_str(), &status) == 0 && (status.st_mode & 0777U) == kModeWhileWritten;
}

std::int64_t changed_ns(const std::filesystem::path& file) {
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0) return 0;
  return std::int64_t{1'000'000'000} * status.st_ctim.tv_sec + status.st_ctim.tv_nsec;
}

void settle_file(const std::filesystem::path& file) {
  File whole(file, O_RDONLY);
  whole.set_mode(kMode);
  whole.sync();
  sync_folder(file.parent_path());
}

std::string read_start(const std::filesystem::path& file, std::size_t limit) {
  return File(file, O_RDONLY).read(0, limit);
}

std::string read_whole(const std::filesystem::path& file) {
  std::error_code failure;
  const auto size = std::filesystem::file_size(file, failure);
  if (failure) throw error::store_failed("measuring", file.string(), failure.value());
  return read_start(file, static_cast<std::size_t>(size));
}

}  // namespace remeshd
