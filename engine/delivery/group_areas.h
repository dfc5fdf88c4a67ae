#pragma once

#include <string>
#include <vector>

#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Exact and meshed areas of the facet groups on faces that several feature faces share out among
/// them: there a seam of coplanar faces, which is no model edge, may cross facets, and a group's
/// facets cover its faces only about.
///
/// Exact areas are those of the cellular model's faces. Post: in the order of the groups.
std::vector<GroupArea> group_areas(const PagedMesh& mesh, const MeshGroups& groups,
                                   const FeatureModel& model, const Membership& membership,
                                   const CellularModel& cells);

}  // namespace remeshd
