#pragma once

#include <span>
#include <vector>

#include "engine/base/surface.h"
#include "engine/kernel/brep.h"
#include "engine/local_fuse/gave_up.h"

namespace remeshd {

/// A use of an edge by a region of a cylinder. Of a straight one: whether the region lies ahead,
/// where the angle about the axis is larger.
struct CylinderUse {
  int edge = -1;
  bool ahead = false;
};

/// The faces that edges bound on a cylinder, cut open at an angle about its axis where only seams
/// may cross from one side of the cut to the other; in pieces that hang together. Edges, area,
/// centroid, swept volume and triangles of each are filled in as for a face that looks away from
/// the axis; areas are exact.
///
/// Gives up where the edges do not close or their polylines cross.
Tried<std::vector<kernel::BrepFace>> cylinder_faces(const kernel::Brep& brep,
                                                    std::span<const CylinderUse> uses,
                                                    const Surface& cylinder, double cut);

}  // namespace remeshd
