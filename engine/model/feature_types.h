#pragma once

#include <string>
#include <string_view>

#include "engine/model/feature_model.h"

namespace remeshd {

/// The entry of `feature_types` with this name, nullptr if there is none.
const FeatureTypeInfo* find_feature_type(std::string_view name);

/// The parameter of a type, nullptr if it has none of that name.
const ParameterInfo* find_parameter(const FeatureTypeInfo& type, std::string_view name);

/// `block, cylinder, ...` for hints.
std::string list_feature_types();
/// `radius, height` for hints.
std::string list_parameters(const FeatureTypeInfo& type);

}  // namespace remeshd
