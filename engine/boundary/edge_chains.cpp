#include "engine/boundary/edge_chains.h"

#include <algorithm>
#include <tuple>

#include "engine/base/cow_vector.h"

namespace remeshd {

NearestOnPolyline nearest_on_polyline(std::span<const Vec3> points, const Vec3& p) {
  NearestOnPolyline nearest;
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3& a = points[i];
    const Vec3 step = points[i + 1] - a;
    const double step2 = norm2(step);
    const double t = step2 > 0 ? std::clamp(dot(p - a, step) / step2, 0.0, 1.0) : 0.0;
    const double distance2 = norm2(p - (a + t * step));
    if (distance2 < nearest.distance2) nearest = {distance2, length + t * std::sqrt(step2)};
    length += std::sqrt(step2);
  }
  return nearest;
}

double polyline_length(const BoundaryEdge& edge) {
  double length = 0;
  for (std::size_t k = 1; k < edge.points.size(); ++k)
    length += distance(edge.points[k - 1], edge.points[k]);
  return length;
}

Vec3 point_at(const BoundaryEdge& edge, double at) {
  for (std::size_t k = 1; k < edge.points.size(); ++k) {
    const double chord = distance(edge.points[k - 1], edge.points[k]);
    if (at <= chord || k + 1 == edge.points.size())
      return edge.points[k - 1] +
             (chord > 0 ? std::fmin(at / chord, 1.0) : 0.0) * (edge.points[k] - edge.points[k - 1]);
    at -= chord;
  }
  return edge.points.back();
}

template <class Nodes>
std::vector<std::vector<NodeOnEdge>> edge_chains(const BoundaryModel& boundary,
                                                 std::span<const Support> supports,
                                                 const Nodes& nodes) {
  std::vector<std::int32_t> at_vertex(boundary.vertices.size(), -1);
  std::vector<std::vector<NodeOnEdge>> chains(boundary.edges.size());
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const Support& s = supports[n];
    const auto node = static_cast<std::int32_t>(n);
    if (s.kind == Support::Kind::Vertex) at_vertex[s.entity] = node;
    if (s.kind == Support::Kind::Edge)
      chains[s.entity].push_back(
          {nearest_on_polyline(boundary.edges[s.entity].points, nodes[n]).at, node});
  }
  for (std::size_t e = 0; e < chains.size(); ++e) {
    std::vector<NodeOnEdge>& chain = chains[e];
    const BoundaryEdge& edge = boundary.edges[e];
    std::ranges::sort(chain, {}, [](const NodeOnEdge& n) { return std::tuple(n.at, n.node); });
    const double length = polyline_length(edge);
    if (edge.start >= 0 && at_vertex[edge.start] >= 0)
      chain.insert(chain.begin(), {0, at_vertex[edge.start]});
    if (edge.end >= 0 && at_vertex[edge.end] >= 0) chain.push_back({length, at_vertex[edge.end]});
    if (edge.end < 0 && !chain.empty())
      chain.push_back({length + chain.front().at, chain.front().node});
  }
  return chains;
}

template std::vector<std::vector<NodeOnEdge>> edge_chains(const BoundaryModel&,
                                                          std::span<const Support>,
                                                          const std::vector<Vec3>&);
template std::vector<std::vector<NodeOnEdge>> edge_chains(const BoundaryModel&,
                                                          std::span<const Support>,
                                                          const CowVector<Vec3>&);

}  // namespace remeshd
