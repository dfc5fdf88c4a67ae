#pragma once

#include "engine/base/run.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Adds the mid-nodes of a mesh of second order, on the model's own faces and edges, to the output
/// of a revision that is complete otherwise.
///
/// An edge that an edit keeps keeps its mid-node: to the bit, by the same transformation, where
/// both corner nodes are kept and its place is still right. A mid-node whose curved edge would turn
/// a tet over, by a lower bound of the Jacobian determinant, stays in the middle of its corner
/// nodes, and is counted; while the connectivity is kept it stays so, lest it jumps from edit to
/// edit.
///
/// `parent`: the revision that was edited, which the output's node map leads to.
void add_mid_nodes(const Revision& parent, Revision& revision, const Run& run);

}  // namespace remeshd
