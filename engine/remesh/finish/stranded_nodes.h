#pragma once

#include <span>

#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Gives each interior node near the defects that lies on a face this face as its support. The
/// boundary procedure (Sect. 3.3) leaves such nodes where they crowd: in the last iteration every
/// sample is nearest to another node, and no iteration follows that would move the node inside.
/// Its facets would be on no face. Returns the number of nodes that got a support.
int support_stranded_nodes(NodeSet& nodes, std::span<const MeshDefect> defects,
                           const BoundaryModel& boundary, const SizeField& sizes);

}  // namespace remeshd
