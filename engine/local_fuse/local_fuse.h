#pragma once

#include "engine/cellular/cellular_model.h"

namespace remeshd {

/// The cells of an edited model from those of its base, of which all is kept that no changed
/// feature touches: as much work as there is change. Entities, their order, and supports are those
/// of a build from the model alone; coordinates, areas and volumes up to rounding. Where the
/// changed part cannot be made by itself, or the base has no features, all of the model is fused.
/// `geometry_attempts` tells which ways to the changed part were given up, and why.
///
/// Throws what `build_cells(model, run)` throws.
CellularModel build_cells(const FeatureModel& model, const FeatureModel& base_model,
                          const CellularModel& base, const Run& run);

}  // namespace remeshd
