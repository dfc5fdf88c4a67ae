// SPDX-License-Identifier: Apache-2.0
#include "client/formats/read_mesh.h"

#include <fstream>
#include <iterator>

#include "remeshd/mesh_file.h"

namespace remeshd::client {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::error_code problem;
  const auto fail = [&](const char* why) { throw FileError(path.string() + ": " + why); };
  if (std::filesystem::is_directory(path, problem)) fail("it is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("it cannot be opened");
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) fail("it cannot be read");
  return bytes;
}

FileMesh parse(const std::filesystem::path& path, const std::string& bytes) {
  const std::string ending = path.extension().string();
  if (ending == ".vtu") return parse_vtu(bytes);
  if (ending == ".msh") return parse_msh(bytes);
  if (ending == ".inp") return parse_inp(bytes);
  throw FileError("unknown mesh format '" + ending + "'; the endings known are .vtu, .msh, .inp");
}

}  // namespace

FileMesh read_mesh(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  try {
    FileMesh mesh = parse(path, bytes);
    const auto nodes = static_cast<std::int64_t>(mesh.nodes.size());
    for (const auto& tet : mesh.tets)
      for (const std::int32_t node : tet)
        if (node < 0 || node >= nodes) throw FileError("a tet refers to a node that is not there");
    if (mesh.tets.empty()) throw FileError("it has no linear tets");
    return mesh;
  } catch (const FileError& e) {
    throw FormatError(path.string() + ": " + e.what());
  }
}

}  // namespace remeshd::client
