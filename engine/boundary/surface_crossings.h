#pragma once

#include <utility>
#include <vector>

#include "engine/base/run.h"
#include "engine/boundary/surface_mesh.h"

namespace remeshd {

/// Pairs of facets that cut or touch each other elsewhere than at common nodes, in ascending order.
/// Facets in one plane are not compared, nor facets with a common side. Exact predicates decide.
std::vector<std::pair<std::int32_t, std::int32_t>> surface_crossings(const SurfaceMesh& mesh,
                                                                     const Run& run);

}  // namespace remeshd
