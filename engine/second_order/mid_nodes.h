#pragma once

#include "engine/base/run.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Adds the mid-nodes of a mesh of second order, on the model's own faces and edges, to the output
/// of a revision that is complete otherwise.
///
/// Where an edit keeps an edge, its mid-node keeps its id. It also keeps its position, to the bit
/// up to the transformation of the corner nodes, where both of these are kept and the position is
/// still right. An edge is straightened, with its mid-node in the middle of the corner nodes, where
/// it would bend by more than half its length, or where it is the most bent edge of a tet whose
/// Jacobian determinant may fall below 0.1 of that of the straight tet (`least_jacobian`). Such
/// mid-nodes are counted; while the connectivity is kept they stay in the middle, so that none
/// jumps from edit to edit.
///
/// `parent`: the revision that was edited, which the output's node map leads to.
void add_mid_nodes(const Revision& parent, Revision& revision, const Run& run);

}  // namespace remeshd
