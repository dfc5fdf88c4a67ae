#pragma once

#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Leaves out free nodes that stand nearer to another node than nodes of an optimised mesh do.
///
/// Copies of different origin and new nodes crowd where they are put together, most of all where a
/// boundary, which had a layer of nodes of its own, is inside the modified model. Relocation
/// spreads nodes over a few edge lengths only, so that such layers would stay, and grow along a
/// chain of edits.
///
/// Nodes inside go first, then those of faces, then of edges; new ones before copies. Nodes of two
/// faces, or of two edges, do not crowd each other: both sides of a thin wall keep theirs. Supports
/// are those of the original boundary. Post: the nodes that are left are in the order they were in;
/// fixed ones and those at vertices are all there.
void decimate_close_nodes(CopiedNodes& nodes, const SizeField& sizes);

}  // namespace remeshd
