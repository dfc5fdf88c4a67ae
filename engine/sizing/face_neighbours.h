#pragma once

#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// For each face those that it shares an edge or a vertex with, and itself; ascending.
std::vector<std::vector<int>> face_neighbours(const BoundaryModel& boundary);

}  // namespace remeshd
