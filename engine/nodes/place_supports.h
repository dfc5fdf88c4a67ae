#pragma once

#include "engine/boundary/samples.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

/// x edge length: how far a node looks for samples of what it stands on. A face's are .36 apart.
inline constexpr double kSupportReach = 1.2;

/// Finds for every fixed node from `first` on that stood on the boundary of the original model the
/// vertex, edge or face of the modified one that it stands on now, of a kind no stronger than
/// before: a node of a face stays one. A node that finds none is freed: its piece of boundary is
/// gone. Free nodes lose their supports.
///
/// `tolerance`: distance within which a node counts as standing on an entity, length.
void place_supports(NodeSet& nodes, const BoundaryModel& boundary, const Samples& samples,
                    const SizeField& sizes, double tolerance, std::int32_t first, const Run& run);

}  // namespace remeshd
