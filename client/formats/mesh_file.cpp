// SPDX-License-Identifier: Apache-2.0
#include "remeshd/mesh_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <system_error>

namespace remeshd::client {
namespace {

struct MeshFormat {
  std::string_view name;
  std::string (*encode)(const Mesh&);
};

constexpr std::array kFormats{MeshFormat{"vtu", to_vtu}, MeshFormat{"msh", to_msh},
                              MeshFormat{"inp", to_inp}};

/// The format of an ending with its dot, or null.
const MeshFormat* format_of_ending(const std::string& ending) {
  for (const MeshFormat& format : kFormats)
    if (ending == "." + std::string(format.name)) return &format;
  return nullptr;
}

}  // namespace

bool is_mesh_file_name(const std::filesystem::path& path) {
  return format_of_ending(path.extension().string()) != nullptr;
}

std::string mesh_in_format(const std::string& name, const Mesh& mesh) {
  if (const MeshFormat* format = format_of_ending("." + name)) return format->encode(mesh);
  throw FileError("unknown mesh format '" + name + "'; those known are vtu, msh and inp");
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) {
  const std::string ending = path.extension().string();
  const MeshFormat* format = format_of_ending(ending);
  if (format == nullptr)
    throw FileError(path.string() + ": unknown mesh format '" + ending +
                    "'; the endings known are .vtu, .msh and .inp");
  write_file(path, format->encode(mesh));
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  // Devices and pipes are written to; a regular file is replaced at once, so that nobody reads half
  // of it.
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool direct = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  const std::string target =
      direct ? path.string() : path.string() + ".part" + std::to_string(::getpid());
  const auto fail = [&](const char* what) {
    const std::string why = std::strerror(errno);
    if (!direct) ::unlink(target.c_str());
    throw FileError(path.string() + ": cannot " + what + ": " + why);
  };
  const int file = ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("create");
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::write(file, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int why = errno;
      ::close(file);
      errno = why;
      fail("write");
    }
    done += static_cast<std::size_t>(n);
  }
  if (::close(file) != 0) fail("write");
  if (!direct && std::rename(target.c_str(), path.c_str()) != 0) fail("replace");
}

}  // namespace remeshd::client
