#pragma once

#include <filesystem>
#include <string_view>

#include "engine/mesh/tet_mesh.h"

namespace remeshd::client {

/// Reads nodes and linear tets of a mesh file, for measuring; other elements are passed over and
/// the order of a tet's corners is left as it is.
///
/// `.vtu`: appended (raw or base64), inline binary or ASCII, with or without zlib. `.msh`:
/// Gmsh 4.1, ASCII or binary. `.inp`: `*NODE` and `*ELEMENT` of C3D4. Throws FileError for another
/// ending, and for a file that cannot be read or is not well-formed.
TetMesh read_mesh(const std::filesystem::path& path);

/// The same from the bytes of a file. Throw FileError.
TetMesh parse_vtu(std::string_view bytes);
TetMesh parse_msh(std::string_view bytes);
TetMesh parse_inp(std::string_view bytes);

}  // namespace remeshd::client
