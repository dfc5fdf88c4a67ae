#pragma once

#include <string>

#include "engine/base/vec.h"
#include "engine/model/source.h"

namespace remeshd {

class Scope;

/// Local to world: columns are the right-handed orthonormal axes, the last one the origin.
///
/// zAxis defaults to 0 0 1, xAxis to 1 0 0 or, where zAxis lies along that, to 0 1 0; xAxis is made
/// perpendicular to zAxis. Axes along the world's come out exact.
/// Throws Error(InvalidArgument): DEGENERATE_FRAME for a zero axis or an explicit xAxis parallel to
/// zAxis, and whatever evaluating the numbers finds.
Transform evaluate_placement(const PlacementSource& source, const Scope& scope,
                             const std::string& feature);

}  // namespace remeshd
