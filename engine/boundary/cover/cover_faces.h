#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/boundary/surface_mesh.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// A mesh of the model's boundary of which a part is missing.
struct OpenSurface {
  SurfaceMesh mesh;  ///< all nodes; the facets that stay
  /// Nodes in the open part that are on none of the facets that stay. The cover may use those of
  /// them that stand on faces.
  std::vector<std::int32_t> loose;
  /// Triangles in the material that facets may not cut: they separate the open part from tets that
  /// stay.
  std::vector<Triangle> walls;
  /// Where the facets of earlier covers have proved to be too large: smaller ones are made there.
  std::vector<Vec3> finer_at;
};

/// Covers the parts of the model's faces that the facets that stay leave open: each face by itself,
/// by a constrained Delaunay triangulation of its loose nodes in the plane, bordered by these
/// facets and the face's edges. Where facets of the cover cut others, or stand off a curved face,
/// it gets more nodes.
///
/// The new facets come last in `open.mesh`, as do new nodes. Returns why it could not be done;
/// empty where it was. Pre: the facets that stay lie on their faces without overlapping, so that
/// their sides and the model edges are the whole border of what is open.
/// Source: Chew 1989, "Constrained Delaunay triangulations", per face.
std::string cover_open_faces(OpenSurface& open, const BoundaryModel& boundary,
                             const SizeField& sizes, const Run& run);

}  // namespace remeshd
