#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/kernel/brep.h"

namespace remeshd {

/// A point of a cell, found halfway between two of its facets.
struct CellSample {
  Vec3 point;
  double depth = 0;  ///< distance to the nearest facet of the cell
  Vec3 from, to;     ///< the facets' points that it lies between
};

/// At most `count` points inside a cell, the deepest first: each halfway on a ray that goes from
/// the middle of one of its largest facets straight inwards to the facet opposite. Facets
/// approximate curved faces, so only a depth above the facets' distance from the true face proves
/// that a sample lies inside.
///
/// Near a tangency facets may cross, so that a sample lies outside of them after all.
std::vector<CellSample> sample_cell(const kernel::Brep& brep, int cell, int count);

/// Winding number of the facets of a cell about a point: 1 inside, 0 outside, to within rounding.
double winding_number(const kernel::Brep& brep, int cell, const Vec3& p);

}  // namespace remeshd
