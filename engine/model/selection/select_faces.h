#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/feature_model.h"
#include "engine/model/selection/selector.h"

namespace remeshd {

class Scope;

/// Work that the selectors of one model have caused so far; `kSelectorLimits` bounds it.
struct SelectorCost {
  std::size_t questions = 0;   ///< tests of a term against a feature
  std::size_t conditions = 0;  ///< conditions, each counted for every feature its term names
};

/// Values of a feature's parameters by name, defaults included, the profile left out.
std::map<std::string, double> numbers_of(const FeatureSource& feature, const Scope& scope);

/// The faces of the features that a selector names, in the order of history. For each feature first
/// one entry for all faces named without a condition, then one for each term with a condition.
/// Names in a condition are those of `kPlaceNames`, else the feature's parameters, else the
/// model's. `features`: those of the document, evaluated; `parameter` says whose selector it is.
/// Adds to `cost`.
///
/// Throws Error(InvalidArgument) naming feature and parameter where the selector or a condition
/// cannot be read, or where `cost` exceeds `kSelectorLimits`.
std::vector<SelectedFaces> select_faces(std::string_view selector, const ModelSource& source,
                                        const std::vector<Feature>& features, const Scope& scope,
                                        const std::string& parameter, SelectorCost& cost);

}  // namespace remeshd
