#pragma once

#include <span>

#include "engine/cellular/boundary_model/support.h"
#include "engine/model/solid.h"
#include "engine/revision/revision.h"
#include "engine/verify/surface_facets.h"

namespace remeshd {

/// The cells that the tets of an earlier mesh are in: a tet of the same number is still in the same
/// one, unless it is among `others`.
struct CellsBefore {
  const MeshGroups* groups = nullptr;  ///< of the earlier mesh; null: there is none
  std::vector<std::int32_t> others;    ///< tets that may be in another cell, ascending
};

/// Names the boundary facets and the tets of a finished mesh: each facet with the feature faces
/// that contain its centroid (the latest owner on the material side first, then the others, latest
/// first), each tet with the owners of its cell.
///
/// `surface`: the facets of the mesh that are in one tet, as verification found them.
/// `before`: what is known from the mesh that this one was made from.
/// Post: facets in the order of `surface`; groups sorted by names, cells by owners.
MeshGroups name_groups(const PagedMesh& mesh, std::span<const SurfaceFacet> surface,
                       const CowVector<Support>& supports, const FeatureModel& model,
                       const Membership& membership, const BoundaryModel& boundary,
                       const CellsBefore& before, const Run& run);

}  // namespace remeshd
