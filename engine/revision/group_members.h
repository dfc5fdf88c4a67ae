#pragma once

#include <vector>

#include "engine/model/feature_model.h"
#include "engine/revision/output_mesh.h"

namespace remeshd {

/// What each group of a model has of its mesh: the facets on a face that it names, and the tets of
/// the features that it names as a whole; of those under a condition the ones at whose centroids it
/// holds, a facet's with its own normal, a tet's with none. In the order of the model's groups.
std::vector<GroupMembers> group_members(const OutputMesh& output, const FeatureModel& model);

}  // namespace remeshd
