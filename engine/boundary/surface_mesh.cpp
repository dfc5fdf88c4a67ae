#include "engine/boundary/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/base/error.h"
#include "engine/boundary/control_mesh.h"
#include "engine/boundary/edge_chains.h"

namespace remeshd {
namespace {

using HalfEdge = std::pair<std::int32_t, std::int32_t>;

/// Facets of the joined triangulation, each with its face.
SurfaceMesh join_faces(const BoundaryModel& boundary) {
  kernel::TetGenSurface joined = joined_surface(boundary);
  SurfaceMesh mesh;
  mesh.nodes = std::move(joined.points);
  std::size_t next = 0;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    for (std::size_t k = 0; k < boundary.faces[f].triangles.size(); ++k)
      mesh.facets.push_back({joined.triangles[next++], {-1, -1, -1}, static_cast<std::int32_t>(f)});
  return mesh;
}

/// The model edge between two faces that a side runs along: the nearest by its polyline, for
/// `project` may come out on another edge of the same two surfaces.
std::int32_t edge_along(const BoundaryModel& boundary, int f, int g, const Vec3& a, const Vec3& b) {
  const std::vector<int> faces{std::min(f, g), std::max(f, g)};
  std::int32_t best = -1;
  double nearest = HUGE_VAL;
  for (const int e : boundary.faces[f].edges) {
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.faces != faces) continue;
    double far = 0;
    for (const Vec3& p : {a, b, 0.5 * (a + b)})
      far = std::max(far, std::sqrt(nearest_on_polyline(edge.points, p).distance2));
    if (far >= nearest) continue;
    nearest = far;
    best = e;
  }
  return best;
}

/// Finds the sides along model edges: those with another face beyond.
void find_sides(SurfaceMesh& mesh, const BoundaryModel& boundary) {
  std::map<HalfEdge, std::int32_t> facet_of;
  for (std::size_t k = 0; k < mesh.facets.size(); ++k) {
    const Triangle& t = mesh.facets[k].nodes;
    for (int i = 0; i < 3; ++i)
      if (!facet_of.try_emplace({t[i], t[(i + 1) % 3]}, static_cast<std::int32_t>(k)).second)
        throw error::kernel_failure("two triangulated faces overlap", mesh.nodes[t[i]]);
  }
  for (FaceFacet& facet : mesh.facets)
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = facet.nodes[i], b = facet.nodes[(i + 1) % 3];
      const auto beyond = facet_of.find({b, a});
      if (beyond == facet_of.end())
        throw error::kernel_failure("the triangulated faces do not close the boundary off",
                                    mesh.nodes[a]);
      const std::int32_t other = mesh.facets[beyond->second].face;
      if (other == facet.face) continue;
      // Lower node first: the facets on both sides compute the same and find the same edge.
      facet.edge[i] = edge_along(boundary, facet.face, other, mesh.nodes[std::min(a, b)],
                                 mesh.nodes[std::max(a, b)]);
      if (facet.edge[i] < 0)
        throw error::kernel_failure("two triangulated faces meet where the model has no edge",
                                    mesh.nodes[a]);
    }
}

void find_supports(SurfaceMesh& mesh, const BoundaryModel& boundary) {
  mesh.supports.resize(mesh.nodes.size());
  for (const FaceFacet& facet : mesh.facets)
    for (const std::int32_t n : facet.nodes) mesh.supports[n] = {Support::Kind::Face, facet.face};
  for (const FaceFacet& facet : mesh.facets)
    for (int i = 0; i < 3; ++i)
      if (facet.edge[i] >= 0)
        for (const std::int32_t n : {facet.nodes[i], facet.nodes[(i + 1) % 3]})
          mesh.supports[n] = {Support::Kind::Edge, facet.edge[i]};
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v) {
    const Vec3& p = boundary.vertices[v].position;
    const auto nearest =
        std::ranges::min_element(mesh.nodes, {}, [&](const Vec3& node) { return norm2(node - p); });
    mesh.supports[nearest - mesh.nodes.begin()] = {Support::Kind::Vertex,
                                                   static_cast<std::int32_t>(v)};
  }
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    mesh.nodes[n] = project(boundary, mesh.supports[n], mesh.nodes[n]);
}

}  // namespace

SurfaceMesh tessellated_surface(const BoundaryModel& boundary) {
  SurfaceMesh mesh = join_faces(boundary);
  find_sides(mesh, boundary);
  find_supports(mesh, boundary);
  return mesh;
}

}  // namespace remeshd
