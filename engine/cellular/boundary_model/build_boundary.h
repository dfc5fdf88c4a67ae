#pragma once

#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/kernel/brep.h"

namespace remeshd {

/// Joins the boundary's pieces into model faces, edges and vertices.
///
/// Pre: one piece for each face of `brep`; `unified` is what `unified_edges_of` gives of these for
/// the boundary.
/// Pre: the boundary is manifold (require_manifold).
/// Source: Sect. 4.1, but that seams and splits between coplanar faces are no edges.
BoundaryModel build_boundary(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces,
                             const UnifiedEdges& unified);

/// Names of all pieces of a face, each once: those of owners of the material, then the others; of
/// each kind the latest feature first.
std::vector<FaceName> ordered_names(const std::vector<const BoundaryPiece*>& pieces);

/// Throws Error(NON_MANIFOLD_MODEL) where the boundary touches itself along an edge or at a vertex,
/// with the place but without the features.
void require_manifold(const kernel::Brep& brep, const UnifiedEdges& unified);

}  // namespace remeshd
