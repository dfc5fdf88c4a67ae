#pragma once

#include "engine/model/feature_model.h"

namespace remeshd::bench {

/// Builds the merged solid of a model in Gmsh's current model by OpenCASCADE's Boolean operations,
/// feature by feature in history order: an additive one is fused to what there is, with coplanar
/// faces unified, a subtractive one is cut out of it.
///
/// Returns the tag of the one volume.
/// Throws std::runtime_error where no single volume results, or whatever Gmsh throws.
int build_merged_solid(const FeatureModel& model);

}  // namespace remeshd::bench
