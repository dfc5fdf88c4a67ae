#pragma once

#include "engine/model/feature_model.h"

namespace remeshd {

class Scope;

/// Evaluates the parameters and profile of a feature.
///
/// Throws Error(InvalidArgument) with feature and parameter: unknown type, missing or extra
/// parameters, sizes that are not finite, not positive or out of range, sizes that do not fit each
/// other, and profiles that `evaluate_profile` or `evaluate_half_profile` refuse.
Shape evaluate_shape(const FeatureSource& source, const Scope& scope);

}  // namespace remeshd
