#pragma once

#include <span>
#include <string_view>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// Writes the nodes as they stand at a stage, with the tets given, to `NAME.vtu` in the run's
/// folder for dumps (VTK XML, text). Names start with the stage's number so that files sort by
/// stage: `05-nodes`, `07-optimise-04`. Does nothing where the run has no such folder.
///
/// Point data: `new` (1: not copied), `free`, `boundary` (1: stands on a vertex, edge or face).
/// Throws Error(Internal) where the file cannot be written.
void dump_nodes(const Run& run, std::string_view name, const NodeSet& nodes,
                std::span<const Tet> tets = {});

}  // namespace remeshd
