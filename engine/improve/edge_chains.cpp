#include "engine/improve/edge_chains.h"

#include <algorithm>
#include <utility>

#include "engine/base/cow_vector.h"

namespace remeshd {

double curve_parameter(const BoundaryEdge& edge, const Vec3& p) {
  double best = HUGE_VAL;
  double parameter = 0;
  double length = 0;
  for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
    const Vec3& a = edge.points[i];
    const Vec3 step = edge.points[i + 1] - a;
    const double step2 = norm2(step);
    const double t = step2 > 0 ? std::clamp(dot(p - a, step) / step2, 0.0, 1.0) : 0.0;
    const double distance2 = norm2(p - (a + t * step));
    if (distance2 < best) {
      best = distance2;
      parameter = length + t * std::sqrt(step2);
    }
    length += std::sqrt(step2);
  }
  return parameter;
}

template <class Nodes>
std::vector<std::vector<std::int32_t>> edge_chains(const BoundaryModel& boundary,
                                                   std::span<const Support> supports,
                                                   const Nodes& nodes) {
  std::vector<std::int32_t> vertex_node(boundary.vertices.size(), -1);
  std::vector<std::vector<std::pair<double, std::int32_t>>> on_edge(boundary.edges.size());
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const Support& support = supports[n];
    const auto node = static_cast<std::int32_t>(n);
    if (support.kind == Support::Kind::Vertex) vertex_node[support.entity] = node;
    if (support.kind == Support::Kind::Edge)
      on_edge[support.entity].emplace_back(
          curve_parameter(boundary.edges[support.entity], nodes[n]), node);
  }
  std::vector<std::vector<std::int32_t>> chains(boundary.edges.size());
  for (std::size_t e = 0; e < chains.size(); ++e) {
    std::sort(on_edge[e].begin(), on_edge[e].end());
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.start >= 0 && vertex_node[edge.start] >= 0)
      chains[e].push_back(vertex_node[edge.start]);
    for (const auto& [parameter, node] : on_edge[e]) chains[e].push_back(node);
    if (edge.end >= 0) {
      if (vertex_node[edge.end] >= 0) chains[e].push_back(vertex_node[edge.end]);
    } else if (!chains[e].empty()) {
      chains[e].push_back(chains[e].front());
    }
  }
  return chains;
}

template std::vector<std::vector<std::int32_t>> edge_chains(const BoundaryModel&,
                                                            std::span<const Support>,
                                                            const std::vector<Vec3>&);
template std::vector<std::vector<std::int32_t>> edge_chains(const BoundaryModel&,
                                                            std::span<const Support>,
                                                            const CowVector<Vec3>&);

}  // namespace remeshd
