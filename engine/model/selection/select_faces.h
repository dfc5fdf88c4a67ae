#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/model/feature_model.h"
#include "engine/model/selection/selector.h"

namespace remeshd {

class Scope;

/// The numbers of a feature by name, as its expressions would see them.
std::map<std::string, double> numbers_of(const FeatureSource& feature, const Scope& scope);

/// The faces of the features that the terms of a selector name, in the order of history: for each
/// feature first those that are named without a condition, then those of each term that has one,
/// whose expression sees coordinates and normal, then the feature's parameters, then the model's.
/// `features`: those of the document, evaluated; `parameter` says whose selector it is.
///
/// Throws Error(InvalidArgument) naming feature and parameter where a condition cannot be read.
std::vector<SelectedFaces> select_faces(std::span<const SelectorTerm> terms,
                                        const ModelSource& source,
                                        const std::vector<Feature>& features, const Scope& scope,
                                        const std::string& parameter);

}  // namespace remeshd
