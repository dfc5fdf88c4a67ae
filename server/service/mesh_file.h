#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/session/held_revision.h"

namespace remeshd {

/// The formats of mesh files, by their usual endings without the dot.
const std::vector<std::string>& mesh_file_formats();

/// Throws Error: OPTIONS_INVALID for a format that is none of them.
void check_mesh_file_format(std::string_view format);

/// The mesh of a revision as a file. Takes time and memory in proportion to the mesh: for the lane
/// of computations. Pre: a known format.
std::string mesh_file(const HeldRevision& revision, std::string_view format);

/// Bytes that `mesh_file` takes at its peak, its result among them, beside the revision.
std::uint64_t mesh_file_memory(const HeldRevision& revision);

}  // namespace remeshd
