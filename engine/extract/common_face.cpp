#include "engine/extract/common_face.h"

#include <algorithm>
#include <numeric>

namespace remeshd {

FacesOf::FacesOf(const BoundaryModel& boundary)
    : face_(boundary.faces.size()),
      edge_(boundary.edges.size()),
      vertex_(boundary.vertices.size()) {
  std::iota(face_.begin(), face_.end(), 0);
  for (const BoundaryFace& face : boundary.faces)
    plane_.push_back(face.surface.kind == Surface::Kind::Plane);
  for (std::size_t e = 0; e < edge_.size(); ++e) edge_[e] = boundary.edges[e].faces;
  for (std::size_t v = 0; v < vertex_.size(); ++v) {
    for (const int e : boundary.vertices[v].edges)
      vertex_[v].insert(vertex_[v].end(), edge_[e].begin(), edge_[e].end());
    if (boundary.vertices[v].edges.empty())  // the apex of a cone
      for (std::size_t f = 0; f < face_.size(); ++f) {
        const auto index = static_cast<std::int32_t>(f);
        if (incident(boundary, {Support::Kind::Vertex, static_cast<std::int32_t>(v)},
                     {Support::Kind::Face, index}))
          vertex_[v].push_back(index);
      }
    std::sort(vertex_[v].begin(), vertex_[v].end());
    vertex_[v].erase(std::unique(vertex_[v].begin(), vertex_[v].end()), vertex_[v].end());
  }
}

std::span<const int> FacesOf::operator()(const Support& support) const {
  switch (support.kind) {
    case Support::Kind::Face:
      return {&face_[support.entity], 1};
    case Support::Kind::Edge:
      return edge_[support.entity];
    case Support::Kind::Vertex:
      return vertex_[support.entity];
    case Support::Kind::Interior:
      break;
  }
  return {};
}

int FacesOf::common(std::span<const Support> supports) const {
  int first = -1;
  for (const int face : (*this)(supports[0])) {
    const bool shared = std::all_of(supports.begin() + 1, supports.end(), [&](const Support& s) {
      const auto faces = (*this)(s);
      return std::binary_search(faces.begin(), faces.end(), face);
    });
    if (!shared) continue;
    if (plane_[face]) return face;
    if (first < 0) first = face;
  }
  return first;
}

}  // namespace remeshd
