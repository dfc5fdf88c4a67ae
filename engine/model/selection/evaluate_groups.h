#pragma once

#include <vector>

#include "engine/model/feature_model.h"

namespace remeshd {

class Scope;
struct SelectorCost;

/// The groups of a document. `features`: its features, evaluated; `scope`: its parameters.
///
/// Throws Error(InvalidArgument) with name and field of the group: bad or duplicate names, names
/// that are a feature's id, selectors that cannot be read, an area change that is negative. A
/// selector may name nothing. Adds to `cost`.
std::vector<FaceGroup> evaluate_groups(const ModelSource& source,
                                       const std::vector<Feature>& features, const Scope& scope,
                                       SelectorCost& cost);

}  // namespace remeshd
