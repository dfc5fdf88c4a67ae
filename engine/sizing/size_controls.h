#pragma once

#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/feature_model.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// What the size controls of a model ask for: a source for each face of its boundary and each part
/// of space that they name, of a face named with a condition one for each triangle of what it holds
/// on, of a feature's material one for each of the balls that cover it. Of several on one whole
/// face only the least length is asked for.
std::vector<SizeSource> size_sources(const FeatureModel& model, const BoundaryModel& boundary,
                                     const Run& run);

/// The same of parts of space that nobody named.
SizeSource size_source(const SizedBall& ball);

/// Ids of the controls whose selectors name nothing of the boundary and no material, in their
/// order.
std::vector<std::string> sizes_of_nothing(const FeatureModel& model, const BoundaryModel& boundary,
                                          const Run& run);

}  // namespace remeshd
