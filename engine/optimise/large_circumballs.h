#pragma once

#include <cstdint>
#include <span>

#include "engine/base/inside_test.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Puts new nodes into the voids of a Delaunay mesh: to the circumcentres of tets between interior
/// nodes whose balls are larger than those of an optimised mesh, largest first, none nearer to
/// another of them than the radius of such a ball. Returns how many it put.
///
/// `tets`: of the Delaunay mesh of the nodes, where voids are looked for.
std::int32_t insert_at_circumcentres(NodeSet& nodes, std::span<const Tet> tets,
                                     const InsideTest& inside, const SizeField& sizes);

}  // namespace remeshd
