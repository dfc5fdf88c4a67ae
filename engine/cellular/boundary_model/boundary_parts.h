#pragma once

#include <string_view>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/kernel/brep.h"

namespace remeshd {

/// A face of the B-rep that bounds material.
struct BoundaryPiece {
  bool boundary = false;
  bool outward = true;  ///< whether its triangles look out of the material as they stand
  Surface surface;      ///< of the first name
  std::vector<FaceName> material_names;  ///< feature faces that cover it, of owners of the material
  std::vector<FaceName> other_names;     ///< of other features
  Box box;  ///< of all the face, where triangles cut it short too; of boundary parts only

  /// Whether the same faces of features cover both, on one surface.
  [[nodiscard]] bool continues(const BoundaryPiece& other) const {
    return surface.kind == other.surface.kind && surface.frame == other.surface.frame &&
           material_names == other.material_names && other_names == other.other_names;
  }
};

/// The faces of a general fuse that bound material, with all their numbers but without the CAD
/// kernel's shapes and cells: what the boundary is joined from, and what an edit keeps where
/// nothing changed.
///
/// Inv: one piece for each face, boundary and outward, its volume swept from brep.reference
/// positive where that lies behind the face; every vertex and edge bounds a face; a vertex has the
/// same index among the points. The order is by geometry.
struct BoundaryParts {
  kernel::Brep brep;
  std::vector<BoundaryPiece> pieces;
  /// How they came about: `fused` by the CAD kernel; of an edit, sewn into what is `kept` of
  /// its base: nothing, or what was `fused in part`, `swept` or `crossed`. Empty where they were
  /// stored.
  std::string_view geometry = {};
};

/// Takes the pieces that are boundary out of a fuse.
///
/// Pre: one piece for each face of `brep`.
BoundaryParts boundary_parts(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces);

/// Leaves out vertices, edges and points that no face needs and puts the rest into the order of
/// its geometry, which noise does not change.
void put_in_canonical_order(BoundaryParts& parts);

/// The same for vertices, edges and points alone; faces stay where they are.
void put_edges_in_canonical_order(kernel::Brep& brep);

/// The box of an edge or face, where chords cut it short too.
Box box_of(const kernel::BrepEdge& edge);
Box box_of(const kernel::Brep& brep, const kernel::BrepFace& face, const Surface& surface);

/// Whether a part of an edge meets one of the boxes: finer than box_of.
bool touches(const std::vector<Box>& boxes, const kernel::BrepEdge& edge);
/// Whether a part of a face does, apart from what lies between its edges and their chords.
bool touches(const std::vector<Box>& boxes, const kernel::Brep& brep, const kernel::BrepFace& face,
             const Surface& surface);

/// Whether the triangles of a face look where the normal of its surface does.
bool looks_along(const kernel::Brep& brep, const kernel::BrepFace& face, const Surface& surface);

}  // namespace remeshd
