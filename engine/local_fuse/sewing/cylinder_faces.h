#pragma once

#include <span>
#include <vector>

#include "engine/base/surface.h"
#include "engine/kernel/brep.h"
#include "engine/local_fuse/gave_up.h"

namespace remeshd {

/// A use of an edge by a region of a cylinder. An edge with the region on both sides has two.
struct CylinderUse {
  int edge = -1;
  bool ahead = false;  ///< of a straight edge: the region is on the side of larger angles
};

/// The faces that edges bound on a cylinder, one for each connected piece. Edges, area, centroid,
/// swept volume and triangles of each are filled in as for a face whose normal points away from the
/// axis; areas are exact.
///
/// `cut`: angle about the axis (rad, in the cylinder's frame) at which the cylinder is opened to be
/// unrolled.
///
/// Pre: no edge crosses the line at `cut`; where the region does, the line consists of seams there,
/// which are edges with two uses.
///
/// Gives up where the edges do not close or their polylines cross.
Tried<std::vector<kernel::BrepFace>> cylinder_faces(const kernel::Brep& brep,
                                                    std::span<const CylinderUse> uses,
                                                    const Surface& cylinder, double cut);

}  // namespace remeshd
