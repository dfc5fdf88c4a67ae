#pragma once

#include "engine/cellular/cellular_model.h"

namespace remeshd {

/// The cellular model of an edited model. Whatever no changed feature touches is taken from the
/// base's cellular model; only the rest is made anew. Entities, their order, and supports are those
/// of a build from the model alone, as are coordinates, areas and volumes up to rounding. Where the
/// changed part cannot be made by itself, or the base has no features, the whole model is fused.
/// `geometry_attempts` of the result lists the routes to the changed part that were given up, and
/// why.
///
/// Throws what `build_cells(model, run)` throws.
CellularModel build_cells(const FeatureModel& model, const FeatureModel& base_model,
                          const CellularModel& base, const Run& run);

}  // namespace remeshd
