#pragma once

#include <string_view>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/kernel/brep.h"

namespace remeshd {

/// What is known of a face of a B-rep beside its geometry.
struct BoundaryPiece {
  bool boundary = false;  ///< whether there is material on one side of it only
  bool outward = true;    ///< whether its triangles face away from the material
  Surface surface;        ///< of the first of `material_names`, else of `other_names`
  /// Feature faces that cover it, of features that own the material behind it; latest first.
  std::vector<FaceName> material_names;
  std::vector<FaceName> other_names;  ///< those of other features; latest first
  Box box;  ///< of the true face, which may bulge beyond its triangles; in BoundaryParts only

  /// Whether both have the same names and lie on one surface, and so may be parts of one face.
  [[nodiscard]] bool continues(const BoundaryPiece& other) const {
    return surface.kind == other.surface.kind && surface.frame == other.surface.frame &&
           material_names == other.material_names && other_names == other.other_names;
  }
};

/// The faces of a general fuse that bound material, with all their numbers but without the CAD
/// kernel's shapes and cells: what the boundary is joined from, and what an edit keeps where
/// nothing changed.
///
/// Inv: one piece for each face, with `boundary` and `outward` true; a face's `swept_volume` is
/// positive where brep.reference lies behind it, on the material's side; every vertex and edge
/// bounds a face; brep.points begin with the vertices, in their order. All elements are ordered by
/// geometry.
struct BoundaryParts {
  kernel::Brep brep;
  std::vector<BoundaryPiece> pieces;
  /// The route by which they were made. `fused`: all of them by the CAD kernel. Else they are the
  /// base's, with what changed replaced by parts that were `fused in part`, `swept` or `crossed`,
  /// or by none (`kept`). Empty where they were read from storage.
  std::string_view geometry = {};
};

/// The faces of a fuse that are boundary, turned outward, in canonical order.
///
/// Pre: one piece for each face of `brep`.
BoundaryParts boundary_parts(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces);

/// Removes vertices, edges and points that no face needs and sorts the rest, faces included, by
/// geometry (`tolerant_ranks`), so that noise does not change the order.
void put_in_canonical_order(BoundaryParts& parts);

/// The same without sorting the faces.
void put_edges_in_canonical_order(kernel::Brep& brep);

/// A box that holds the true edge or face, which may bulge beyond its chords or triangles.
Box box_of(const kernel::BrepEdge& edge);
Box box_of(const kernel::Brep& brep, const kernel::BrepFace& face, const Surface& surface);

/// Whether an edge meets one of the boxes, judged by a box per chord: finer than box_of.
bool touches(const std::vector<Box>& boxes, const kernel::BrepEdge& edge);
/// Whether a face does, judged by a box per triangle; a plane face's part between an edge and its
/// chords does not count.
bool touches(const std::vector<Box>& boxes, const kernel::Brep& brep, const kernel::BrepFace& face,
             const Surface& surface);

/// Whether the triangles of a face are oriented along the normal of its surface.
bool looks_along(const kernel::Brep& brep, const kernel::BrepFace& face, const Surface& surface);

}  // namespace remeshd
