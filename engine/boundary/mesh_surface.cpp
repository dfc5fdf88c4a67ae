#include "engine/boundary/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/error.h"
#include "engine/boundary/surface_crossings.h"
#include "engine/boundary/surface_remesher.h"

namespace remeshd {
namespace {

struct SurfaceMeshing {
  int rounds = 6;               ///< of splitting, collapsing, flipping and evening out
  int rounds_per_crossing = 2;  ///< after each refinement at crossings
  double per_width = 2.0;       ///< longest sides beside a thin face, x its width
  double per_radius = 1.0;      ///< longest sides on a curve, x its radius: a circle is a hexagon
  int least_segments = 6;       ///< sides along a closed model edge, at least
};
constexpr SurfaceMeshing kMesh;

/// Smallest radius of curvature; of a cone or torus at least `least`, for it is 0 at an apex.
double radius_of(const Surface& surface, const Vec3& p, double least) {
  using Kind = Surface::Kind;
  const double radius = radius_of_curvature(surface, p);
  return surface.kind == Kind::Cone || surface.kind == Kind::Torus ? std::max(least, radius)
                                                                   : radius;
}

/// How long sides may be for the curvature of what a node stands on.
double longest_on_curve(const BoundaryModel& boundary, const Support& support, const Vec3& p,
                        double least) {
  if (support.kind == Support::Kind::Face)
    return kMesh.per_radius * radius_of(boundary.faces[support.entity].surface, p, least);
  if (support.kind != Support::Kind::Edge) return HUGE_VAL;
  const BoundaryEdge& edge = boundary.edges[support.entity];
  double length = edge.closed() ? edge.length / kMesh.least_segments : HUGE_VAL;
  if (edge.curve.kind == Curve::Kind::Circle)
    length = std::min(length, kMesh.per_radius * edge.curve.radius);
  for (const int f : edge.faces)
    length = std::min(length, kMesh.per_radius * radius_of(boundary.faces[f].surface, p, least));
  return length;
}

/// Asks for shorter sides beside those that cannot be collapsed: across thin faces and along whole
/// model edges.
void heed_thin_faces(SurfaceRemesher& remesher, double least) {
  using Kind = Support::Kind;
  const SurfaceMesh& mesh = remesher.mesh();
  for (const FaceFacet& f : mesh.facets)
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = f.nodes[i], b = f.nodes[(i + 1) % 3];
      // Across a face from edge to edge, or along all of an edge.
      const Kind rigid = f.edge[i] < 0 ? Kind::Edge : Kind::Vertex;
      if (mesh.supports[a].kind < rigid || mesh.supports[b].kind < rigid) continue;
      if (rigid == Kind::Edge && mesh.supports[a] == mesh.supports[b]) continue;  // a chord
      const double width = distance(mesh.nodes[a], mesh.nodes[b]);
      for (const std::int32_t n : {a, b})
        remesher.shorten(n, std::max(kMesh.per_width * width, least));
    }
  remesher.grade();
}

/// Asks for sides half as long at facets that cut others; false where there are none.
bool heed_crossings(SurfaceRemesher& remesher, const Run& run) {
  const SurfaceMesh& mesh = remesher.mesh();
  const auto crossings = surface_crossings(mesh, run);
  for (const auto& [s, t] : crossings)
    for (const std::int32_t k : {s, t}) {
      const Triangle& nodes = mesh.facets[k].nodes;
      double longest = 0;
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, distance(mesh.nodes[nodes[i]], mesh.nodes[nodes[(i + 1) % 3]]));
      for (const std::int32_t n : nodes) remesher.shorten(n, 0.5 * longest);
    }
  remesher.grade();
  return !crossings.empty();
}

void remesh(SurfaceRemesher& remesher, int rounds, double least, std::size_t most_facets) {
  for (int round = 0; round < rounds; ++round) {
    remesher.split_long();
    remesher.flip();
    remesher.collapse_short();
    remesher.flip();
    remesher.even_out();
    remesher.flip();
    remesher.compact();
    heed_thin_faces(remesher, least);
    if (remesher.mesh().facets.size() > most_facets) throw error::surface_too_fine(most_facets);
  }
}

}  // namespace

SurfaceMesh mesh_surface(const BoundaryModel& boundary, const SurfaceMeshOptions& options,
                         const Run& run) {
  const double least = options.least_length * (options.share * options.sizes.least());
  const auto longest = [&](const Support& support, const Vec3& p) {
    return std::min(options.share * options.sizes(p),
                    longest_on_curve(boundary, support, p, least));
  };
  SurfaceRemesher remesher(tessellated_surface(boundary), boundary, longest, run);
  remesher.flip();
  // This asks for shorter sides at narrow places before any side is collapsed. Else a long chord of
  // the curve on one side of such a place may reach across the curve on the other side. Nodes of
  // the second curve would then lie between the first curve and its chord, and no later step moves
  // them out.
  heed_thin_faces(remesher, least);
  // The triangulation has long slivers, and splitting a sliver gives slivers again: sides are split
  // in steps, and short ones collapsed in between.
  for (const double limit : {64.0, 32.0, 16.0, 8.0, 4.0, 2.0}) {
    remesher.split_long(limit);
    remesher.flip();
    remesher.collapse_short();
  }
  remesh(remesher, kMesh.rounds, least, options.most_facets);
  for (int round = 0; round < options.crossing_rounds; ++round) {
    if (!heed_crossings(remesher, run)) break;
    remesh(remesher, kMesh.rounds_per_crossing, least, options.most_facets);
  }
  return remesher.mesh();
}

}  // namespace remeshd
