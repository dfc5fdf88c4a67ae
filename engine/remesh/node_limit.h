#pragma once

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/density.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// The limit on nodes (`Run::max_nodes`), the same whether a request gives their number or an edge
/// length, or inherits its base's. An edit never has a larger edge length than its base.

/// Volume, area and lengths of a model, from which `nodes_needed` follows.
Extent extent_of(const CellularModel& cells);

/// Checks the limit before anything is computed, as far as closed formulas tell: what passes may
/// still be refused once the model's cells are known. Returns how many nodes the mesh will have at
/// least, as far as that can be told.
///
/// Throws Error(InvalidArgument) `MESH_TOO_LARGE`, naming the feature where one alone is too large.
double check_node_limit(const Revision& original, const FeatureModel& model,
                        const MeshOptions& options, const Run& run);

/// Checks the number of new nodes that a sized mesh begins with, known only once they are made.
/// Those that an edit keeps are not counted.
///
/// Throws Error(InvalidArgument) `MESH_TOO_LARGE`, naming the option that asks for the size.
void check_new_nodes(std::size_t nodes, const MeshOptions& options, const Run& run);

/// Checks the limit by the exact volume and area of the model. `edge_length`: as resolved.
///
/// Throws Error(InvalidArgument) `MESH_TOO_LARGE`.
void check_node_limit(const Revision& original, const Extent& extent, double edge_length,
                      const MeshOptions& options, const Run& run);

}  // namespace remeshd
