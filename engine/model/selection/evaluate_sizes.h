#pragma once

#include <vector>

#include "engine/model/feature_model.h"

namespace remeshd {

class Scope;
struct SelectorCost;

/// The size controls of a document, with their numbers. `features`: its features, evaluated;
/// `scope`: its parameters.
///
/// Throws Error(InvalidArgument) with id and field of the size: bad or duplicate ids, selectors
/// that cannot be read, lengths that are not positive, boxes without a volume, and whatever
/// evaluating the numbers finds. A selector may name nothing. Adds to `cost`.
std::vector<SizeControl> evaluate_sizes(const ModelSource& source,
                                        const std::vector<Feature>& features, const Scope& scope,
                                        SelectorCost& cost);

}  // namespace remeshd
