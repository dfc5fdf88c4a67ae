#pragma once

#include <vector>

#include "engine/model/feature_model.h"
#include "engine/revision/output_mesh.h"

namespace remeshd {

/// What each group of a model has of its mesh: the facets on faces that it names, and the tets of
/// features that it names as a whole; where it sets a condition, only those at whose centroid that
/// holds, for a facet with its normal, for a tet without one. In the order of the model's groups.
std::vector<GroupMembers> group_members(const OutputMesh& output, const FeatureModel& model);

}  // namespace remeshd
