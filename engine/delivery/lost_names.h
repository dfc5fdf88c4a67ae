#pragma once

#include <vector>

#include "engine/base/warning.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Warnings of what a client would look for in vain in a mesh: faces and groups of facets that the
/// original's mesh names and this one does not, features that neither add nor remove anything,
/// groups of the model that select nothing, and size controls whose selectors name nothing. Faces,
/// groups of facets and features are found by names and bounding boxes alone; groups of the model
/// and size controls by what they select.
///
/// Each lost face of a feature that is still there has its own warning; those of a removed feature
/// have one together. A feature that has lost its effect is told beside its faces. What was without
/// effect or selected nothing in the original already gets none. `original`: `Revision::none()` for
/// a first mesh.
std::vector<Warning> lost_names(const Revision& original, const Revision& made, const Run& run);

/// The warnings of `lost_names` that are certain before there is a mesh, from the model and the
/// boundary alone: a verified mesh has a facet on each face, and none with a name that its face has
/// not. What depends on where tets lie is left out: whether a feature without a face still has
/// material, and groups on faces that several features share.
std::vector<Warning> names_to_be_lost(const Revision& original, const FeatureModel& model,
                                      const BoundaryModel& boundary, const Run& run);

}  // namespace remeshd
