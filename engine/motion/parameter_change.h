#pragma once

#include <string>

#include "engine/model/feature_model.h"

namespace remeshd {

/// A model at two values of a parameter, one on either side of its own.
struct ParameterChange {
  FeatureModel less, more;
  double between = 0;  ///< of the two values
};

/// Value of a parameter of the model, `wall`, or of a feature, `hole.radius`.
///
/// Throws Error(InvalidArgument): `UNKNOWN_PARAMETER`, `UNKNOWN_FEATURE`; `WRONG_VALUE_KIND` for a
/// profile.
double parameter_value(const ModelSource& source, const std::string& parameter);

/// The model with another value of the parameter. Bounds of parameters are not enforced, and size
/// controls and groups are left out. Throws what `apply` and `evaluate` throw.
FeatureModel with_value(const ModelSource& source, const std::string& parameter, double value);

/// The model with the parameter changed by a small step to either side: 1e-6 of its value, or of a
/// thousandth of the model's diagonal where that is more. Differences of closed forms are then
/// exact to about 1e-9, relative. On a side where there is no valid model: the model itself.
///
/// Throws what `parameter_value` and `evaluate` throw, and `WRONG_VALUE_KIND` for a parameter that
/// has only whole values, or where there is no valid model on either side.
ParameterChange change_of(const ModelSource& source, const std::string& parameter);

}  // namespace remeshd
