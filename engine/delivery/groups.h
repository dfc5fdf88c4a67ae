#pragma once

#include <span>

#include "engine/cellular/boundary_model/support.h"
#include "engine/model/solid.h"
#include "engine/revision/revision.h"
#include "engine/verify/surface_facets.h"

namespace remeshd {

/// Cells of an earlier mesh, of which tets of the same number still have theirs.
struct CellsBefore {
  const MeshGroups* groups = nullptr;  ///< null: as if there were none
  std::vector<std::int32_t> others;    ///< tets that may be in another cell, ascending
};

/// Names the boundary facets and the tets of a finished mesh: each facet with the feature faces
/// that contain its centroid (the latest owner on the material side first, then the others, latest
/// first), each tet with the owners of its cell.
///
/// `surface`: the facets of the mesh that are in one tet, as verification found them.
/// Post: facets in the order of `surface`; groups and cells sorted by name and by owners.
///
/// `before`: what is known from the mesh that this one was made from.
MeshGroups name_groups(const PagedMesh& mesh, std::span<const SurfaceFacet> surface,
                       const CowVector<Support>& supports, const FeatureModel& model,
                       const Membership& membership, const BoundaryModel& boundary,
                       const CellsBefore& before, const Run& run);

}  // namespace remeshd
