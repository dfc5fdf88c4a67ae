#pragma once

#include "engine/model/feature_model.h"

namespace remeshd {

class Scope;

/// The numbers of a feature's type.
///
/// Throws Error(InvalidArgument) with feature and parameter: unknown type, missing or extra
/// parameters, sizes that are not finite, not positive or out of range, sizes that do not fit each
/// other, and profiles that enclose no area properly.
Shape evaluate_shape(const FeatureSource& source, const Scope& scope);

}  // namespace remeshd
