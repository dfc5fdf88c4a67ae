#pragma once

#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/feature_model.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// What the size controls of a model ask for. They give a source for each face of the boundary that
/// is named as a whole, with the least length where several controls name it, or for each of its
/// triangles where it is plane and no rectangle along the axes; for each triangle of the part of a
/// face where a condition holds, or that is of one of several flush features; for each ball or box;
/// and for each of the balls that cover the material of a feature. What they ask for is shorter
/// than what the controls do, by `kReserveOnFaces` and `kReserveInside`.
std::vector<SizeSource> size_sources(const FeatureModel& model, const BoundaryModel& boundary,
                                     const Run& run);

/// The source of a ball in which edges are to be of this length, no finer.
SizeSource size_source(const SizedBall& ball);

/// Ids of the controls whose ball or box lies outside of these bounds, in their order.
std::vector<std::string> sizes_outside(const FeatureModel& model, const Box& bounds);

/// Ids of the controls whose selectors name nothing of the boundary and no material, in their
/// order.
std::vector<std::string> sizes_of_nothing(const FeatureModel& model, const BoundaryModel& boundary,
                                          const Run& run);

}  // namespace remeshd
