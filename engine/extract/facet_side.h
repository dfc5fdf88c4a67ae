#pragma once

#include <cstdint>

#include "engine/boundary/facet_faces.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

enum class BoundarySide : std::uint8_t { Unknown, Inside, Outside };

/// The side of the boundary on which a tet of boundary nodes lies, judged by its facets on curved
/// faces, where the tet is so thin over one that its centroid does not tell: a facet is a chord of
/// the face, outside of the model on a concave face and inside on a convex one, and the centroid
/// of a thin tet may lie between the two. Beside a ledge narrower than the chords' sagitta all tets
/// are like that. Unknown where the tet is thin over no facet, or two facets disagree; a facet does
/// not count where the fourth node is between it and its face, as on a pin that stands out of a
/// hole's wall by less than the sagitta: it cannot be the boundary there.
BoundarySide side_by_facets(const NodeSet& nodes, const BoundaryModel& boundary,
                            const FacesOf& faces, const Tet& tet);

}  // namespace remeshd
