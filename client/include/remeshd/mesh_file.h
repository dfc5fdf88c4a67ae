// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "remeshd/mesh.h"

namespace remeshd::client {

/// A mesh file that cannot be written or read; `what()` names the file and says why.
class FileError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that can be read, but is no mesh in the format of its ending.
class FormatError : public FileError {
  using FileError::FileError;
};

/// Whether `write_mesh` knows the ending: `.vtu`, `.msh` or `.inp`.
bool is_mesh_file_name(const std::filesystem::path& path);

/// The bytes of a mesh file in a format, `vtu`, `msh` or `inp`. Throws FileError for another.
std::string mesh_in_format(const std::string& format, const Mesh& mesh);

/// Writes a mesh in the format of the path's ending; coordinates read back to the same bits. The
/// file appears whole or not at all.
///
/// Throws FileError for another ending and where the file cannot be written.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Writes bytes to a file that appears whole or not at all; a device or pipe is written to.
///
/// Throws FileError.
void write_file(const std::filesystem::path& path, const std::string& bytes);

/// In each format a mesh of second order has its mid-nodes after all corner nodes, and comments
/// tell the revision, its parent, the model's name and unit, and the options.
///
/// VTK XML unstructured grid: tets, then boundary triangles, outward (types 10 and 5, or 24 and
/// 22), raw appended data, compressed by zlib.
///
/// Point data: `origin` (0 new, 1 kept, 2 moved), `original_node` (-1 where new), `transform`
/// (index, -1 where new), `node_id`; of mid-nodes `original_node` counts the parent's mid-nodes,
/// from 0. Cell data: `face` (of a triangle: its facet group; colour the surface by it),
/// `group:G` (1 where the cell is in the model's group G); of tets `kept` (0, 1), `original_tet`
/// (-1 where not kept), `tet_id`, `cell` (of the cellular model), `owner:F` (1 where feature F owns
/// the tet's cell) and `facet_groups` (four numbers: the group of the facet opposite each corner,
/// -1 inside); triangles have 0 or -1 there. Field data: `face:F.f` (the facet groups that lie on
/// this face), `transform:K` (12 numbers).
std::string to_vtu(const Mesh& mesh);

/// Gmsh 4.1, binary, triangles and tets of types 2 and 4, or 9 and 11. Node tags are 1 + index, tet
/// tags 1 + index, facet tags follow the tets'.
///
/// One volume entity for each cell and one surface entity for each facet group, or several where
/// groups of the model take parts of it. Physical groups: one for each cell and facet group, named
/// by all its owners or faces (`base+slot1`); where such a name joins several, one for each single
/// feature and face; and one for each group of the model. Those of volumes are numbered after those
/// of surfaces.
std::string to_msh(const Mesh& mesh);

/// Abaqus and CalculiX input: `*NODE`, `*ELEMENT` of C3D4 or C3D10; a node set and an element
/// surface (S1..S4) for each group of the model that has facets and for each face, an element set
/// for each group that has tets and for each owner; element and node sets `remesh_all`, or
/// `remesh_all_2` where a group of the model has that name.
///
/// Labels are the names of the groups, features and faces with `.` written as `_`, because Abaqus
/// takes a dot for an instance; labels are not sensitive to case there, so one that is taken gets
/// `_2`.
std::string to_inp(const Mesh& mesh);

}  // namespace remeshd::client
