#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/inside_test.h"
#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/optimise/node_lengths.h"

namespace remeshd {

/// By node, 1 for those that `relocate` moves: free interior ones.
std::vector<std::uint8_t> relocated(const NodeSet& nodes);

/// Moves every free interior node to the volume-weighted mean of the circumcentres of its tets
/// (formula 1 of Sect. 3.3; Chen 2003), with step 1. Where the field is not even, volumes count by
/// the density of nodes that it asks for, 1 / h^3 (Alliez et al. 2005). A node that this would move
/// out of the model, for one in a crowd on the boundary may have no samples and tets on both sides,
/// goes by its tets inside alone, or stays.
///
/// `tets`: all those at such nodes; others may be among them. `lengths`: of the nodes where they
/// are now.
void relocate(NodeSet& nodes, std::span<const Tet> tets, const InsideTest& inside,
              const NodeLengths& lengths, const Run& run);

/// Mean volume-length measure of the tets at nodes that `relocate` moves; 0 without any.
double mean_quality(const NodeSet& nodes, std::span<const Tet> tets, const Run& run);

}  // namespace remeshd
