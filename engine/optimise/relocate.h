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
/// (formula 1 of Sect. 3.3; Chen 2003), without damping. Where the size field is not even, volumes
/// are weighted by the density of nodes that it asks for, 1 / h^3 (Alliez et al. 2005). Where a
/// node would leave the model, only its tets inside of the model count; if it would still leave, it
/// stays. That happens where nodes crowd on the boundary: one of them may have no samples, and tets
/// on both sides of the boundary.
///
/// `tets`: all tets at free interior nodes; others may be among them. `lengths`: up to date with
/// the nodes' positions.
void relocate(NodeSet& nodes, std::span<const Tet> tets, const InsideTest& inside,
              const NodeLengths& lengths, const Run& run);

/// Mean volume-length measure of the tets at nodes that `relocate` moves; 0 without any.
double mean_quality(const NodeSet& nodes, std::span<const Tet> tets, const Run& run);

}  // namespace remeshd
