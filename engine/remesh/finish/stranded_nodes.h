#pragma once

#include <span>

#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Gives nodes of the inside near the defects that stand on a face that face as their support. The
/// boundary procedure (Sect. 3.3) leaves such where nodes are crowded: each sample is nearest to
/// another node in the last iteration, and no iteration follows that would move the node inside.
/// Facets with it would be on no face. Returns their number.
int support_stranded_nodes(NodeSet& nodes, std::span<const MeshDefect> defects,
                           const BoundaryModel& boundary, const SizeField& sizes);

}  // namespace remeshd
