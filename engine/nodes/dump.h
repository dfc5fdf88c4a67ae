#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Writes the nodes as they stand at a stage, with the tets given, to `NAME.vtu` in the run's
/// folder for dumps (VTK XML, text). Names start with the stage's number so that files sort by
/// stage: `05-nodes`, `07-optimise-04`. Does nothing where the run has no such folder.
///
/// Point data: `new` (1: not copied), `free`, `boundary` (1: stands on a vertex, edge or face),
/// `size` (the edge length aimed at).
/// Throws Error(Internal) where the file cannot be written.
void dump_nodes(const Run& run, std::string_view name, const NodeSet& nodes, const SizeField& sizes,
                std::span<const Tet> tets = {});

/// Writes what a stage decided to `NAME.txt` in the same folder; where there is none, `text` is not
/// called. Throws as above.
void dump_text(const Run& run, std::string_view name, const std::function<std::string()>& text);

}  // namespace remeshd
