// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace remeshd::client {

/// Nodes, and the corners of the tets, as a file has them. Indices are 0-based.
struct FileMesh {
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::array<std::int32_t, 4>> tets;
};

/// Reads nodes and tets of first and second order of a mesh file, for measuring; other elements are
/// passed over and the order of a tet's corners is left as it is.
///
/// `.vtu`: appended (raw or base64), inline binary or ASCII, with or without zlib. `.msh`:
/// Gmsh 4.1, ASCII or binary. `.inp`: `*NODE` and `*ELEMENT` of C3D4 and C3D10. Throws FileError
/// for a file that cannot be read, FormatError for another ending and one that is not well-formed.
FileMesh read_mesh(const std::filesystem::path& path);

/// The same from the bytes of a file. Throw FileError.
FileMesh parse_vtu(std::string_view bytes);
FileMesh parse_msh(std::string_view bytes);
FileMesh parse_inp(std::string_view bytes);

}  // namespace remeshd::client
