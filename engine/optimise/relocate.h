#pragma once

#include <span>

#include "engine/base/inside_test.h"
#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// Moves every free interior node to the volume-weighted mean of the circumcentres of its tets
/// (formula 1 of Sect. 3.3; Chen 2003), with step 1. A move out of the model is not made.
///
/// Returns the mean volume-length measure of the tets at free nodes before the move.
double relocate(NodeSet& nodes, std::span<const Tet> tets, const InsideTest& inside,
                const Run& run);

}  // namespace remeshd
