#include <algorithm>
#include <map>

#include "engine/base/error.h"
#include "engine/cellular/boundary_model/build_boundary.h"

namespace remeshd {
namespace {

/// Number of fans that the faces round a vertex fall into; 1 where the boundary is a surface there.
int fans(const UnifiedEdges& unified, const std::vector<int>& edges) {
  std::map<int, int> parent;
  const auto find = [&](int f) {
    while (parent[f] != f) f = parent[f];
    return f;
  };
  for (const int e : edges)
    for (const int f : unified.faces_at_edge[e]) parent.emplace(f, f);
  for (const int e : edges)
    for (const int f : unified.faces_at_edge[e])
      parent[find(f)] = find(unified.faces_at_edge[e].front());
  return static_cast<int>(std::count_if(parent.begin(), parent.end(),
                                        [](const auto& p) { return p.first == p.second; }));
}

}  // namespace

void require_manifold(const kernel::Brep& brep, const UnifiedEdges& unified) {
  std::vector<std::vector<int>> edges_at_vertex(brep.vertices.size());
  for (int e = 0; e < static_cast<int>(brep.edges.size()); ++e) {
    const auto n = unified.faces_at_edge[e].size();
    if (n == 0) continue;
    if (n != 2) throw error::non_manifold_model("along an edge", brep.edges[e].middle(), {});
    for (const int v : brep.edges[e].vertices) edges_at_vertex[v].push_back(e);
  }
  for (std::size_t v = 0; v < edges_at_vertex.size(); ++v)
    if (!edges_at_vertex[v].empty() && fans(unified, edges_at_vertex[v]) != 1)
      throw error::non_manifold_model("at a vertex", brep.vertices[v].position, {});
}

}  // namespace remeshd
