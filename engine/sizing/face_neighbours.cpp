#include "engine/sizing/face_neighbours.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace remeshd {

std::vector<std::vector<int>> face_neighbours(const BoundaryModel& boundary) {
  std::vector<std::vector<int>> faces_at(boundary.vertices.size());
  std::vector<std::vector<int>> neighbours(boundary.faces.size());
  const auto join = [&](std::span<const int> faces) {
    for (const int a : faces)
      for (const int b : faces) neighbours[a].push_back(b);
  };
  for (const BoundaryEdge& edge : boundary.edges) {
    join(edge.faces);
    for (const int vertex : {edge.start, edge.end})
      if (vertex >= 0)
        faces_at[vertex].insert(faces_at[vertex].end(), edge.faces.begin(), edge.faces.end());
  }
  for (const auto& faces : faces_at) join(faces);
  for (std::size_t f = 0; f < neighbours.size(); ++f) {
    neighbours[f].push_back(static_cast<int>(f));
    std::ranges::sort(neighbours[f]);
    const auto twice = std::ranges::unique(neighbours[f]);
    neighbours[f].erase(twice.begin(), twice.end());
  }
  return neighbours;
}

}  // namespace remeshd
