#pragma once

#include <functional>

#include "engine/base/random.h"
#include "engine/base/surface.h"

namespace remeshd {

/// Calls `visit(point)` for the points of a jittered lattice on a surface: for those in `within`,
/// and for some outside of it. The lattice consists of rows along the first parameter of the
/// surface, one after another along the second. Neighbours are about `spacing` (a length) apart,
/// whatever the curvature. `jitter`, x spacing: each point is displaced at random by up to half of
/// it along its row, and by up to half of it across. `box` says where rows begin and end; `within`
/// may reach beyond it by one spacing.
///
/// The cost depends on the size of the boxes, not of the surface, even where a radius is a million
/// times larger. Exception: of a sphere or torus, up to about 2000 rows outside of the boxes are
/// passed over without a point.
void visit_lattice(const Surface& surface, const Box& box, const Box& within, double spacing,
                   double jitter, Random& random, const std::function<void(const Vec3&)>& visit);

}  // namespace remeshd
