#pragma once

#include <array>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd::campaign {

/// What faces, edges and vertices there are and which bounds which, without their places: two
/// boundaries of different signature have different topology.
using Topology = std::vector<std::array<std::size_t, 3>>;

Topology topology(const BoundaryModel& boundary);

}  // namespace remeshd::campaign
