#include "tests/disk/file_calls.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using Kind = FileCall::Kind;

struct Recorder {
  std::string root;
  FileRecord record;
  FileCalls::Decide decide;
  bool records_opening = false;
  std::map<int, std::string> open_files;                        ///< by descriptor
  std::map<std::string, std::function<void()>> before_opening;  ///< by path
  std::function<void(const std::string&)> before_syncing;

  std::optional<std::string> below_root(const char* path) const {
    const std::string text(path);
    if (text == root) return ".";
    if (!text.starts_with(root + "/")) return std::nullopt;
    return text.substr(root.size() + 1);
  }
};

std::mutex mutex;
Recorder* recorder = nullptr;

/// Tells whoever waits for that file to be opened, who may open files.
void tell_before_opening(const char* path) {
  std::function<void()> before;
  {
    const std::scoped_lock lock(mutex);
    const auto name = recorder != nullptr ? recorder->below_root(path) : std::nullopt;
    if (!name) return;
    const auto found = recorder->before_opening.find(*name);
    if (found == recorder->before_opening.end()) return;
    before = std::move(found->second);
    recorder->before_opening.erase(found);
  }
  before();
}

/// Tells whoever waits for a file to be synced.
void tell_before_syncing(int descriptor) {
  std::function<void(const std::string&)> before;
  std::string path;
  {
    const std::scoped_lock lock(mutex);
    if (recorder == nullptr || !recorder->open_files.contains(descriptor)) return;
    before = recorder->before_syncing;
    path = recorder->open_files[descriptor];
  }
  if (before) before(path);
}

/// Enters a call and does it. `real` returns what the system call does.
template <typename Real>
long recorded(FileCall call, Real&& real) {
  const int fault = recorder->decide ? recorder->decide(call, recorder->record.calls.size()) : 0;
  if (fault == 0) {
    const long result = real();
    call.failed = result < 0;
    if (!call.failed) recorder->record.calls.push_back(std::move(call));
    return result;
  }
  call.failed = true;
  recorder->record.calls.push_back(std::move(call));
  errno = std::abs(fault);
  return -1;
}

}  // namespace

FileCalls::FileCalls(const fs::path& folder) {
  auto fresh = std::make_unique<Recorder>();
  fresh->root = folder.string();
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = fs::relative(entry.path(), folder).string();
    if (entry.is_directory()) {
      fresh->record.folders.push_back(path);
    } else {
      std::ifstream in(entry.path(), std::ios::binary);
      fresh->record.files[path] = {std::istreambuf_iterator<char>(in), {}};
    }
  }
  const std::scoped_lock lock(mutex);
  recorder = fresh.release();
}
FileCalls::~FileCalls() {
  const std::scoped_lock lock(mutex);
  delete recorder;
  recorder = nullptr;
}
void FileCalls::decide(Decide decide) {
  const std::scoped_lock lock(mutex);
  recorder->decide = std::move(decide);
}
void FileCalls::record_opening() {
  const std::scoped_lock lock(mutex);
  recorder->records_opening = true;
}
void FileCalls::before_opening(const std::string& path, std::function<void()> before) {
  const std::scoped_lock lock(mutex);
  recorder->before_opening[path] = std::move(before);
}
void FileCalls::before_syncing(std::function<void(const std::string&)> before) {
  const std::scoped_lock lock(mutex);
  recorder->before_syncing = std::move(before);
}
void FileCalls::mark(std::uint64_t number) {
  const std::scoped_lock lock(mutex);
  recorder->record.calls.push_back({.kind = Kind::Mark, .at = number});
}
FileRecord FileCalls::record() const {
  const std::scoped_lock lock(mutex);
  return recorder->record;
}

}  // namespace remeshd::test

// What replaces the C library's functions in this program.

namespace rt = remeshd::test;

extern "C" int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  const auto real = [&] { return syscall(SYS_openat, AT_FDCWD, path, flags, mode); };
  if ((flags & O_CREAT) == 0) rt::tell_before_opening(path);
  const std::scoped_lock lock(rt::mutex);
  const auto name = rt::recorder ? rt::recorder->below_root(path) : std::nullopt;
  if (!name) return static_cast<int>(real());
  const bool makes = (flags & O_CREAT) != 0 && syscall(SYS_access, path, F_OK) != 0;
  const long result =
      makes || rt::recorder->records_opening
          ? rt::recorded({.kind = makes ? rt::Kind::Create : rt::Kind::Open, .path = *name}, real)
          : real();
  if (result >= 0) rt::recorder->open_files[static_cast<int>(result)] = *name;
  return static_cast<int>(result);
}

extern "C" int close(int descriptor) {
  const std::scoped_lock lock(rt::mutex);
  if (rt::recorder) rt::recorder->open_files.erase(descriptor);
  return static_cast<int>(syscall(SYS_close, descriptor));
}

extern "C" ssize_t write(int descriptor, const void* bytes, std::size_t count) {
  const auto real = [&](std::size_t size) { return syscall(SYS_write, descriptor, bytes, size); };
  const std::scoped_lock lock(rt::mutex);
  const bool ours = rt::recorder && rt::recorder->open_files.contains(descriptor);
  if (!ours) return real(count);
  const std::string data(static_cast<const char*>(bytes), count);
  struct stat now {};
  fstat(descriptor, &now);
  rt::FileCall call{.kind = rt::Kind::Write,
                    .path = rt::recorder->open_files[descriptor],
                    .data = data,
                    .at = static_cast<std::uint64_t>(now.st_size)};  // every file is appended to
  const int fault =
      rt::recorder->decide ? rt::recorder->decide(call, rt::recorder->record.calls.size()) : 0;
  if (fault < 0 && count > 1) {
    // The first half is written, and the next call fails.
    call.data.resize(count / 2);
    rt::recorder->record.calls.push_back(call);
    return real(count / 2);
  }
  if (fault != 0) {
    call.failed = true;
    rt::recorder->record.calls.push_back(call);
    errno = std::abs(fault);
    return -1;
  }
  rt::recorder->record.calls.push_back(call);
  return real(count);
}

extern "C" int fsync(int descriptor) {
  rt::tell_before_syncing(descriptor);
  const auto real = [&] { return syscall(SYS_fsync, descriptor); };
  const std::scoped_lock lock(rt::mutex);
  const bool ours = rt::recorder && rt::recorder->open_files.contains(descriptor);
  if (!ours) return static_cast<int>(real());
  return static_cast<int>(
      rt::recorded({.kind = rt::Kind::Sync, .path = rt::recorder->open_files[descriptor]}, real));
}

extern "C" int ftruncate(int descriptor, off_t size) noexcept {
  const auto real = [&] { return syscall(SYS_ftruncate, descriptor, size); };
  const std::scoped_lock lock(rt::mutex);
  const bool ours = rt::recorder && rt::recorder->open_files.contains(descriptor);
  if (!ours) return static_cast<int>(real());
  return static_cast<int>(rt::recorded({.kind = rt::Kind::Truncate,
                                        .path = rt::recorder->open_files[descriptor],
                                        .at = static_cast<std::uint64_t>(size)},
                                       real));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  const auto real = [&] { return syscall(SYS_rename, from, to); };
  const std::scoped_lock lock(rt::mutex);
  const auto name = rt::recorder ? rt::recorder->below_root(from) : std::nullopt;
  if (!name) return static_cast<int>(real());
  return static_cast<int>(rt::recorded(
      {.kind = rt::Kind::Rename, .path = *name, .to = rt::recorder->below_root(to).value_or("")},
      real));
}

extern "C" int unlink(const char* path) noexcept {
  const auto real = [&] { return syscall(SYS_unlink, path); };
  const std::scoped_lock lock(rt::mutex);
  const auto name = rt::recorder ? rt::recorder->below_root(path) : std::nullopt;
  if (!name) return static_cast<int>(real());
  return static_cast<int>(rt::recorded({.kind = rt::Kind::Unlink, .path = *name}, real));
}

extern "C" int mkdir(const char* path, mode_t mode) noexcept {
  const auto real = [&] { return syscall(SYS_mkdir, path, mode); };
  const std::scoped_lock lock(rt::mutex);
  const auto name = rt::recorder ? rt::recorder->below_root(path) : std::nullopt;
  if (!name) return static_cast<int>(real());
  if (syscall(SYS_access, path, F_OK) == 0) return static_cast<int>(real());
  return static_cast<int>(rt::recorded({.kind = rt::Kind::MakeFolder, .path = *name}, real));
}
