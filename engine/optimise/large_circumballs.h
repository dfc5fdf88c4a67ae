#pragma once

#include <cstdint>
#include <span>

#include "engine/base/inside_test.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Puts new nodes into the voids of a Delaunay mesh: at the circumcentres, where these lie in the
/// model, of tets of four interior nodes with a larger circumradius (0.75 edge lengths) than an
/// optimised mesh has; the largest first, and none within that radius of another new node. Returns
/// their number.
///
/// `tets`: those of the nodes' Delaunay mesh that are looked at.
std::int32_t insert_at_circumcentres(NodeSet& nodes, std::span<const Tet> tets,
                                     const InsideTest& inside, const SizeField& sizes);

}  // namespace remeshd
