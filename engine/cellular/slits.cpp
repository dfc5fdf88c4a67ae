#include "engine/cellular/slits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/cellular/boundary_model/face_distance.h"

namespace remeshd {
namespace {

/// x the diagonal: a point of a face's surface counts as on the face if this near to its triangles.
constexpr double kOffTriangles = 1e-3;

/// The faces that an edge bounds or meets at its ends, ascending.
std::vector<int> faces_met(const BoundaryModel& boundary, const BoundaryEdge& edge) {
  std::vector<int> faces = edge.faces;
  for (const int vertex : {edge.start, edge.end}) {
    if (vertex < 0) continue;
    for (const int e : boundary.vertices[vertex].edges)
      faces.insert(faces.end(), boundary.edges[e].faces.begin(), boundary.edges[e].faces.end());
  }
  std::ranges::sort(faces);
  return faces;
}

/// Both ends and three places between them.
std::array<Vec3, 5> places_on(const BoundaryEdge& edge) {
  std::array<Vec3, 5> places;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double at = 0.25 * static_cast<double>(k * (edge.points.size() - 1));
    const auto before = std::min(static_cast<std::size_t>(at), edge.points.size() - 2);
    const double t = at - static_cast<double>(before);
    places[k] = (1 - t) * edge.points[before] + t * edge.points[before + 1];
  }
  return places;
}

}  // namespace

bool has_slits(const BoundaryModel& boundary, double widest) {
  const double off_triangles = kOffTriangles * boundary.bounds.diagonal();
  std::vector<Box> boxes;
  for (const BoundaryFace& face : boundary.faces)
    boxes.push_back(grown(box_of(face.points), off_triangles));
  return std::ranges::any_of(boundary.edges, [&](const BoundaryEdge& edge) {
    if (edge.length < widest) return true;
    const std::vector<int> met = faces_met(boundary, edge);
    const std::array<Vec3, 5> places = places_on(edge);
    for (std::size_t f = 0; f < boxes.size(); ++f) {
      if (std::ranges::binary_search(met, static_cast<int>(f))) continue;
      const BoundaryFace& face = boundary.faces[f];
      if (std::ranges::any_of(places, [&](const Vec3& p) {
            return boxes[f].contains(p) && std::fabs(signed_distance(face.surface, p)) < widest &&
                   face_distance2(face, p) < off_triangles * off_triangles;
          }))
        return true;
    }
    return false;
  });
}

}  // namespace remeshd
