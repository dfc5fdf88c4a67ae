#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/run.h"
#include "server/session/session.h"

namespace remeshd {

/// The formats of files of a mesh or its model, by their usual endings without the dot.
const std::vector<std::string>& mesh_file_formats();

/// Throws Error: OPTIONS_INVALID for a format that is none of them.
void check_mesh_file_format(std::string_view format);

/// The mesh of a revision as a file, or its model where the format is `step`. Takes time and memory
/// in proportion to the mesh, or a fuse of the model's features: for the lane of computations.
///
/// Pre: a known format. Throws Error: what `Session::step_of` throws.
std::string mesh_file(const Session& session, const HeldRevision& revision, std::string_view format,
                      const Run& run);

/// Bytes that `mesh_file` takes at its peak, its result among them, beside the revision.
std::uint64_t mesh_file_memory(const HeldRevision& revision, std::string_view format);

}  // namespace remeshd
