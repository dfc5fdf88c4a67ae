#pragma once

#include <cstdint>
#include <span>

#include "engine/base/inside_test.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Circumradii, x edge length, that all but a few in a thousand are below in regular meshes. Half
/// of them are below .63 in even meshes; in sized ones, whose start has .62 to 1.25 times the nodes
/// asked for in a place, below .70 to .80.
inline constexpr double kLargestBallEven = 0.75, kLargestBallSized = 0.95;

/// Puts new nodes into the voids of a Delaunay mesh: at the circumcentres, where these lie in the
/// model, of tets of four interior nodes with a larger circumradius than a regular mesh has; the
/// largest first, and none within that radius of another new node. Returns their number.
///
/// `tets`: those of the nodes' Delaunay mesh that are looked at. `largest`: that circumradius, x
/// edge length.
std::int32_t insert_at_circumcentres(NodeSet& nodes, std::span<const Tet> tets,
                                     const InsideTest& inside, const SizeField& sizes,
                                     double largest);

}  // namespace remeshd
