#include "tests/campaign/topology.h"

#include <algorithm>

namespace remeshd::campaign {

Topology topology(const BoundaryModel& boundary) {
  std::vector<std::vector<int>> neighbours(boundary.faces.size());
  for (const BoundaryEdge& edge : boundary.edges)
    if (edge.faces.size() == 2) {
      neighbours[edge.faces[0]].push_back(edge.faces[1]);
      neighbours[edge.faces[1]].push_back(edge.faces[0]);
    }
  Topology result{{boundary.faces.size(), boundary.edges.size(), boundary.vertices.size()}};
  // A face by its kind, its edges, and the edges of its neighbours.
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    std::size_t beyond = 0;
    for (const int n : neighbours[f]) beyond += boundary.faces[n].edges.size();
    result.push_back({static_cast<std::size_t>(boundary.faces[f].surface.kind),
                      boundary.faces[f].edges.size(), beyond});
  }
  std::sort(result.begin() + 1, result.end());
  return result;
}

}  // namespace remeshd::campaign
