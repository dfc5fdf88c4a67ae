#pragma once

#include <vector>

#include "engine/motion/mesh_spread.h"

namespace remeshd {

/// Where the nodes of a mesh go when its boundary has moved and its connectivity is to stay.
struct HeldPlaces {
  std::vector<Vec3> nodes;
  /// Largest distance from a boundary node's anchor position to the present surface of a face that
  /// it stands on; length.
  double surface_motion = 0;
};

/// Places the nodes of an anchor on another boundary of the same topology: nodes of vertices at the
/// vertices there, nodes of edges and faces on those, and along them where the mesh is stretched
/// least, interior nodes by harmonic extension. The result depends on the anchor and the boundary
/// alone, and smoothly on the boundary.
///
/// `spread`: of the anchor; `supports`: of the nodes, in `boundary`.
HeldPlaces held_places(const CowVector<Vec3>& anchor, const MeshSpread& spread,
                       const std::vector<Support>& supports, const BoundaryModel& boundary,
                       const Run& run);

}  // namespace remeshd
