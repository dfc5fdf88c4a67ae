#pragma once

#include <array>
#include <vector>

#include "engine/base/surface.h"
#include "engine/kernel/brep.h"
#include "engine/local_fuse/gave_up.h"

namespace remeshd {

/// An edge of a B-rep round a region of a plane; `uses` 2 where the region lies on both sides.
struct PlaneEdge {
  int edge = -1;
  int uses = 1;
};

using Triangles = std::vector<std::array<int, 3>>;

/// The faces that edges bound on a plane: the inside by the even-odd rule, one face for each
/// connected piece. Edges, area, centroid, swept volume and triangles of each are filled in as for
/// a face whose normal is the plane's; areas are exact.
///
/// `known`: triangles that are right already, counter-clockwise about the normal; the rest of the
/// region is triangulated.
///
/// Gives up where the edges do not close, their polylines cross, or `known` does not fit them.
Tried<std::vector<kernel::BrepFace>> plane_faces(const kernel::Brep& brep,
                                                 const std::vector<PlaneEdge>& edges,
                                                 const Surface& plane, const Triangles& known);

}  // namespace remeshd
