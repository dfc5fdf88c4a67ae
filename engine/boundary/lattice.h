#pragma once

#include <functional>

#include "engine/base/random.h"
#include "engine/base/surface.h"

namespace remeshd {

/// Calls `visit(point)` for the points of a jittered lattice on the part of the surface that lies
/// in `within`, and for some beyond: rows one after another along the surface's second parameter,
/// each divided evenly along the first, so that neighbours are about `spacing` apart whatever the
/// curvature. `box` says where rows begin and end; `within` may reach beyond it by a spacing.
///
/// The cost depends on the boxes alone, even where a radius is a million times larger; only of
/// spheres and tori up to some 2000 rows outside of them are stepped over.
void visit_lattice(const Surface& surface, const Box& box, const Box& within, double spacing,
                   double jitter, Random& random, const std::function<void(const Vec3&)>& visit);

}  // namespace remeshd
