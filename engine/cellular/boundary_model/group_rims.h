#pragma once

#include <functional>
#include <vector>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/model/feature_model.h"

namespace remeshd {

/// For each piece a number for the groups of the model that name one of its faces, 0 for none:
/// where it changes, the rim of a group stays an edge of the model, even between faces of one
/// surface. Conditions do not count: what they cut through a face is no edge.
std::vector<int> groups_of_pieces(const FeatureModel& model,
                                  const std::vector<BoundaryPiece>& pieces);

/// Of the boundary's faces, rims of groups included; where `all`, of every face, without rims.
UnifiedEdges unified_edges_of(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces,
                              const FeatureModel& model, bool all = false);

/// Points on the edges between faces of one surface that one of two boundaries has and the other
/// has not, since other groups name faces there. `apart`: how far they are from each other at a
/// point, at most.
std::vector<Vec3> changed_rims(const BoundaryModel& a, const BoundaryModel& b,
                               const std::function<double(const Vec3&)>& apart);

}  // namespace remeshd
