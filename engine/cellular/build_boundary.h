#pragma once

#include <vector>

#include "engine/cellular/boundary_model.h"
#include "engine/cellular/skeleton.h"
#include "engine/kernel/brep.h"

namespace remeshd {

/// A face of the B-rep that bounds material.
struct BoundaryPiece {
  bool boundary = false;
  bool outward = true;  ///< whether its triangles look out of the material as they stand
  Surface surface;      ///< of the first name
  std::vector<FaceName> material_names;  ///< feature faces that cover it, of owners of the material
  std::vector<FaceName> other_names;     ///< of other features
};

/// Joins the boundary's pieces into model faces, edges and vertices.
///
/// Pre: one piece for each face of `brep`; `skeleton` is that of the boundary pieces, the side of
/// each telling whether its outward normal is that of its surface.
/// Pre: the boundary is manifold (require_manifold).
/// Source: Sect. 4.1; seams and coplanar splits by DESIGN.
BoundaryModel build_boundary(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces,
                             const Skeleton& skeleton);

/// Throws Error(NonManifoldModel) where the boundary touches itself along an edge or at a vertex,
/// with the place but without the features.
void require_manifold(const kernel::Brep& brep, const Skeleton& skeleton);

}  // namespace remeshd
