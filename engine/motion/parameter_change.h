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

/// The same model with another value; bounds of its parameters do not hold, and its sizes and
/// groups are left out. Throws what `evaluate` throws, too.
FeatureModel with_value(const ModelSource& source, const std::string& parameter, double value);

/// The model a millionth to either side: differences of closed forms are exact to some 1e-9 then.
/// On a side where there is no valid model, the model itself.
///
/// Throws as `parameter_value`, and `WRONG_VALUE_KIND` for a parameter that has whole values alone.
ParameterChange change_of(const ModelSource& source, const std::string& parameter);

}  // namespace remeshd
