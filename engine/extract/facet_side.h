#pragma once

#include <cstdint>

#include "engine/boundary/facet_faces.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

enum class BoundarySide : std::uint8_t { Unknown, Inside, Outside };

/// The side of the boundary on which a tet of boundary nodes lies, by its facets on curved faces,
/// where the tet is so thin against one that its centroid does not tell: a facet is a chord, which
/// leaves the model on a hollow face and lies within it on a round one, and the centroid of a thin
/// tet lies there too. On a ledge narrower than chords are high that is so of all tets beside it.
/// Unknown where no facet is like that, or two do not agree.
BoundarySide side_by_facets(const NodeSet& nodes, const BoundaryModel& boundary,
                            const FacesOf& faces, const Tet& tet);

}  // namespace remeshd
