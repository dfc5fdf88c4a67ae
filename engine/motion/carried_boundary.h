#pragma once

#include "engine/cellular/boundary_model/match_boundary.h"
#include "engine/motion/feature_surfaces.h"

namespace remeshd {

/// Pairs the entities of two boundaries of the same features with other numbers, where the topology
/// is the same. Each is looked for where the surfaces of its features have carried it.
///
/// `reach`: how far from there, length.
std::optional<BoundaryMatch> match_carried(const BoundaryModel& from, const FeatureModel& then,
                                           const BoundaryModel& to, const FeatureModel& now,
                                           double reach);

}  // namespace remeshd
