#pragma once

#include "engine/cellular/boundary_model/match_boundary.h"
#include "engine/motion/feature_surfaces.h"

namespace remeshd {

/// Pairs the entities of two boundaries whose models have the same features with other parameter
/// values. Each entity is looked for where the surfaces of its features have carried it. Returns
/// nothing where the topology is not the same.
///
/// `reach`: how far from there an entity may be, length.
std::optional<BoundaryMatch> match_carried(const BoundaryModel& from, const FeatureModel& then,
                                           const BoundaryModel& to, const FeatureModel& now,
                                           double reach);

}  // namespace remeshd
