#pragma once

#include <functional>
#include <vector>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/model/feature_model.h"

namespace remeshd {

/// For each piece a number for the set of the model's groups that name one of its feature faces,
/// each group together with the condition under which it names the face; 0 is the empty set.
/// Between pieces with different numbers the rim of a group stays an edge of the model, even within
/// one surface. No edge is made inside a face where a condition begins or ceases to hold.
std::vector<int> groups_of_pieces(const FeatureModel& model,
                                  const std::vector<BoundaryPiece>& pieces);

/// The unified edges among the faces that are boundary, rims of groups included; with `all`, among
/// all faces, without rims.
UnifiedEdges unified_edges_of(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces,
                              const FeatureModel& model, bool all = false);

/// Points along the rims (BoundaryEdge::rim) of each of two boundaries that no edge of the other
/// passes through, since groups name other faces there. `apart`: the largest distance between
/// neighbouring points, near a place.
std::vector<Vec3> changed_rims(const BoundaryModel& a, const BoundaryModel& b,
                               const std::function<double(const Vec3&)>& apart);

}  // namespace remeshd
