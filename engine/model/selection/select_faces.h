#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/feature_model.h"
#include "engine/model/selection/selector.h"

namespace remeshd {

class Scope;

/// What the selectors of one model have asked so far, against `kSelectorLimits`.
struct SelectorCost {
  std::size_t questions = 0;   ///< terms, times features
  std::size_t conditions = 0;  ///< times features
};

/// The numbers of a feature by name, as its expressions would see them.
std::map<std::string, double> numbers_of(const FeatureSource& feature, const Scope& scope);

/// The faces of the features that a selector names, in the order of history: for each feature first
/// those that are named without a condition, then those of each term that has one, whose expression
/// sees coordinates and normal, then the feature's parameters, then the model's. `features`: those
/// of the document, evaluated; `parameter` says whose selector it is.
///
/// Throws Error(InvalidArgument) naming feature and parameter where the selector or a condition
/// cannot be read, or where the model's selectors ask more than `kSelectorLimits`.
std::vector<SelectedFaces> select_faces(std::string_view selector, const ModelSource& source,
                                        const std::vector<Feature>& features, const Scope& scope,
                                        const std::string& parameter, SelectorCost& cost);

}  // namespace remeshd
