#pragma once

#include "engine/boundary/samples.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// x edge length: how far a node looks for samples of what it stands on. A face's are .36 apart.
inline constexpr double kSupportReach = 1.2;

/// For every fixed node from `first` on that stood on the boundary of the original model, finds the
/// vertex, edge or face of the modified model that it stands on now. The dimension of that entity
/// is never lower than before: a node of a face gets a face, one of an edge gets an edge or a face.
/// A node that finds none is freed: its piece of boundary is gone. Free nodes lose their supports.
///
/// `tolerance`: distance within which a node counts as standing on an entity, length.
void place_supports(NodeSet& nodes, const BoundaryModel& boundary, const Samples& samples,
                    const SizeField& sizes, double tolerance, std::int32_t first, const Run& run);

}  // namespace remeshd
