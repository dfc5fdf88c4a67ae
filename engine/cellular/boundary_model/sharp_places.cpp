#include "engine/cellular/boundary_model/sharp_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/angle.h"

namespace remeshd {

namespace {

/// Where material is looked for round an edge.
struct EdgeProbes {
  double radius = 1e-6;  ///< of their circle, x the model's diagonal
  int places = 5;        ///< along an edge
  int per_circle = 64;
};
constexpr EdgeProbes kProbes;

/// Angle, rad, that material fills round a point of a curve with direction `along`; counted on a
/// small circle normal to the curve.
double material_angle(const Vec3& p, const Vec3& along, double radius,
                      const Membership& membership) {
  const Vec3 helper = std::fabs(along.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalised(cross(along, helper)), v = cross(along, u);
  int inside = 0;
  for (int k = 0; k < kProbes.per_circle; ++k) {
    const double a = kTurn * (k + 0.5) / kProbes.per_circle;
    inside += membership.inside(p + radius * (std::cos(a) * u + std::sin(a) * v)) ? 1 : 0;
  }
  return kTurn * inside / kProbes.per_circle;
}

bool sharp_edge(const BoundaryModel& boundary, const BoundaryEdge& edge,
                const Membership& membership, double angle) {
  if (edge.faces.size() != 2 || edge.points.size() < 2) return false;
  const BoundaryFace &a = boundary.faces[edge.faces[0]], &b = boundary.faces[edge.faces[1]];
  const double radius = kProbes.radius * boundary.bounds.diagonal();
  const std::size_t last = edge.points.size() - 1;
  for (int k = 0; k < kProbes.places; ++k) {
    // Places between two points of the polyline, the ends' neighbourhoods included.
    const std::size_t i = std::min(last - 1, last * k / (kProbes.places - 1));
    const Vec3 p = project(boundary, edge, 0.5 * (edge.points[i] + edge.points[i + 1]));
    const Vec3 along = edge.points[i + 1] - edge.points[i];
    // Normals that point away from each other: a wedge of material, or a slit in it.
    if (!(norm2(along) > 0) || dot(outward_normal(a, p), outward_normal(b, p)) > -std::cos(angle))
      continue;
    if (material_angle(p, normalised(along), radius, membership) < std::numbers::pi) return true;
  }
  return false;
}

bool share_face(const BoundaryEdge& a, const BoundaryEdge& b) {
  return std::ranges::any_of(a.faces,
                             [&](int f) { return std::ranges::find(b.faces, f) != b.faces.end(); });
}

bool sharp_vertex(const BoundaryModel& boundary, int vertex, double angle) {
  struct Leaving {
    const BoundaryEdge* edge;
    Vec3 direction;
  };
  std::vector<Leaving> leaving;
  for (const int e : boundary.vertices[vertex].edges) {
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.points.size() < 2) continue;
    for (const bool at_start : {true, false})
      if ((at_start ? edge.start : edge.end) == vertex)
        leaving.push_back({&edge, edge.leaving(at_start)});
  }
  for (std::size_t i = 0; i < leaving.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (share_face(*leaving[i].edge, *leaving[j].edge) &&
          dot(leaving[i].direction, leaving[j].direction) > std::cos(angle))
        return true;
  return false;
}

}  // namespace

bool SharpPlaces::any() const {
  const auto set = [](std::uint8_t flag) { return flag != 0; };
  return std::ranges::any_of(edges, set) || std::ranges::any_of(vertices, set);
}

bool SharpPlaces::holds(const Support& support) const {
  if (support.kind == Support::Kind::Vertex) return vertices[support.entity] != 0;
  return support.kind == Support::Kind::Edge && edges[support.entity] != 0;
}

SharpPlaces sharp_places(const BoundaryModel& boundary, const Membership& membership,
                         double angle) {
  SharpPlaces sharp;
  for (const BoundaryEdge& edge : boundary.edges)
    sharp.edges.push_back(sharp_edge(boundary, edge, membership, angle) ? 1 : 0);
  for (int v = 0; v < static_cast<int>(boundary.vertices.size()); ++v)
    sharp.vertices.push_back(sharp_vertex(boundary, v, angle) ? 1 : 0);
  for (std::size_t e = 0; e < boundary.edges.size(); ++e)
    if (sharp.edges[e])
      for (const int v : {boundary.edges[e].start, boundary.edges[e].end})
        if (v >= 0) sharp.vertices[v] = 1;
  return sharp;
}

ThinWalls::ThinWalls(const BoundaryModel& boundary, double thinner_than)
    : boundary_(boundary), thinner_than_(thinner_than), neighbours_(boundary.faces.size()) {
  for (const BoundaryEdge& edge : boundary.edges)
    for (const int a : edge.faces)
      for (const int b : edge.faces) neighbours_[a].push_back(b);
  for (std::size_t f = 0; f < neighbours_.size(); ++f)
    neighbours_[f].push_back(static_cast<int>(f));
}

std::vector<int> ThinWalls::faces_of(const Support& support) const {
  switch (support.kind) {
    case Support::Kind::Interior:
      break;
    case Support::Kind::Face:
      return {support.entity};
    case Support::Kind::Edge:
      return boundary_.edges[support.entity].faces;
    case Support::Kind::Vertex: {
      std::vector<int> faces;
      for (const int e : boundary_.vertices[support.entity].edges)
        faces.insert(faces.end(), boundary_.edges[e].faces.begin(), boundary_.edges[e].faces.end());
      return faces;
    }
  }
  return {};
}

bool ThinWalls::meet(std::span<const int> faces, int face) const {
  return std::ranges::any_of(faces,
                             [&](int f) { return std::ranges::count(neighbours_[f], face) > 0; });
}

bool ThinWalls::holds(const std::array<Support, 4>& supports,
                      const std::array<Vec3, 4>& nodes) const {
  std::array<std::vector<int>, 4> faces;
  for (int i = 0; i < 4; ++i) faces[i] = faces_of(supports[i]);
  for (int i = 0; i < 4; ++i) {
    if (faces[i].empty()) continue;
    for (int j = 0; j < 4; ++j)
      for (const int f : faces[j])
        if (i != j && !meet(faces[i], f) &&
            std::fabs(signed_distance(boundary_.faces[f].surface, nodes[i])) < thinner_than_)
          return true;
  }
  return false;
}

}  // namespace remeshd
