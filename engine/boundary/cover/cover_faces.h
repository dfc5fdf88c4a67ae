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
  /// Nodes on faces where the surface is open, which it may use.
  std::vector<std::int32_t> loose;
  /// Triangles in the material that may not be cut: what parts the open place from tets that stay.
  std::vector<Triangle> walls;
  /// Where facets of the size of those that stay have proved to be too large.
  std::vector<Vec3> finer_at;
};

/// Covers what the facets that stay leave open of the model's faces: each face by itself, by a
/// constrained Delaunay triangulation in the plane between these facets and the face's edges, of
/// the loose nodes. Where its facets cut others, or stand off a curved face, it gets more nodes.
///
/// The new facets come last in `open.mesh`, as do new nodes. Returns why it could not be done;
/// empty where it was. Pre: the facets that stay lie on their faces without overlapping; nothing
/// but their sides and the open surface's own facets lies where it is open.
/// Source: Chew 1989, "Constrained Delaunay triangulations", per face.
std::string cover_open_faces(OpenSurface& open, const BoundaryModel& boundary,
                             const SizeField& sizes, const Run& run);

}  // namespace remeshd
