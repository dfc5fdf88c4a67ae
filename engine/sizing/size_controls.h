#pragma once

#include <string>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/feature_model.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// What the size controls of a model ask for: a source for each face of its boundary and each part
/// of space that they name. Of several on one face only the least length is asked for.
std::vector<SizeSource> size_sources(const std::vector<SizeControl>& sizes,
                                     const BoundaryModel& boundary);

/// The same of parts of space that nobody named.
SizeSource size_source(const SizedBall& ball);

/// Ids of the controls whose selectors name no face of the boundary, in their order.
std::vector<std::string> sizes_of_nothing(const std::vector<SizeControl>& sizes,
                                          const BoundaryModel& boundary);

}  // namespace remeshd
