#pragma once

#include <vector>

#include "engine/model/feature_model.h"
#include "engine/revision/output_mesh.h"

namespace remeshd {

/// The facets and tets that each group of a model selects from its mesh: facets on the faces that
/// it names, and tets of the additive features that it names as a whole. A condition must hold at
/// the centroid, for a facet with its unit outward normal, for a tet with a normal of 0. In the
/// order of the model's groups.
std::vector<GroupMembers> group_members(const OutputMesh& output, const FeatureModel& model);

}  // namespace remeshd
