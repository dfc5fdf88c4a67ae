#pragma once

#include <vector>

#include "engine/motion/mesh_spread.h"

namespace remeshd {

/// Where the nodes of a mesh go when its boundary has moved and its connectivity is to stay.
struct HeldPlaces {
  std::vector<Vec3> nodes;
  double surface_motion = 0;  ///< largest distance of a node from a surface it stood on; length
};

/// Places the nodes of an anchor on another boundary of the same topology: the model's vertices
/// where they are there, nodes of edges and faces on these and otherwise so that the mesh is
/// stretched least, the interior by harmonic extension. It depends on the anchor and the boundary
/// alone, and smoothly on the boundary.
///
/// `spread`: of the anchor; `supports`: of the nodes, in `boundary`.
HeldPlaces held_places(const CowVector<Vec3>& anchor, const MeshSpread& spread,
                       const std::vector<Support>& supports, const BoundaryModel& boundary,
                       const Run& run);

}  // namespace remeshd
