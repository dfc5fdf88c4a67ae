#pragma once

#include <string>
#include <vector>

#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Exact and meshed areas of the facet groups on plane model faces with several names: there a seam
/// between coplanar feature faces, which is no model edge, may cross facets, so that a group's
/// facets cover its part of the face only roughly.
///
/// Exact areas are those of the cellular model's faces. Post: in the order of the groups.
std::vector<GroupArea> group_areas(const PagedMesh& mesh, const MeshGroups& groups,
                                   const FeatureModel& model, const Membership& membership,
                                   const CellularModel& cells);

}  // namespace remeshd
