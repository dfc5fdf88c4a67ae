#pragma once

#include <functional>

#include "engine/base/random.h"
#include "engine/base/surface.h"

namespace remeshd {

/// Calls `visit(point)` for the points of a jittered lattice on the part of the surface that lies
/// in `box` or within `spacing` of it, and for some beyond: rows along the surface's second
/// parameter, each divided evenly along its first, so that neighbours are about `spacing` apart
/// whatever the curvature. The cost goes by the box, even where a radius is a million times larger,
/// but for the rows of spheres and tori, which are counted.
void visit_lattice(const Surface& surface, const Box& box, double spacing, double jitter,
                   Random& random, const std::function<void(const Vec3&)>& visit);

}  // namespace remeshd
