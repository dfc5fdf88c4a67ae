#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

struct NodeOnEdge {
  /// Where it lies along a model edge: arc length of its nearest point on the edge's polyline, from
  /// the start. It grows strictly as a point moves along the curve itself.
  double at;
  std::int32_t node;
};

/// For each model edge the nodes that stand on it or on its end vertices, from start to end. An
/// edge that is closed repeats its first node at the end (its vertex, where it has one).
///
/// A mesh represents the edge if each two neighbours in the chain are joined by a mesh edge.
/// `Nodes`: positions by node.
template <class Nodes>
std::vector<std::vector<NodeOnEdge>> edge_chains(const BoundaryModel& boundary,
                                                 std::span<const Support> supports,
                                                 const Nodes& nodes);

/// The point of a polyline that is nearest to p.
struct NearestOnPolyline {
  double distance2 = HUGE_VAL;  ///< of p from it
  double at = 0;                ///< length of the polyline up to it
};
NearestOnPolyline nearest_on_polyline(std::span<const Vec3> points, const Vec3& p);

/// Length of an edge's polyline.
double polyline_length(const BoundaryEdge& edge);

/// The point at this length along an edge's polyline.
Vec3 point_at(const BoundaryEdge& edge, double at);

}  // namespace remeshd
