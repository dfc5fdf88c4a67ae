#include "engine/boundary/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "engine/boundary/surface_crossings.h"
#include "engine/boundary/surface_remesher.h"

namespace remeshd {
namespace {

constexpr int kRounds = 6;  // of splitting, collapsing, flipping and evening out
constexpr int kRoundsPerCrossing = 2;
constexpr double kGrowth = 0.5;     // of the length asked for, per distance
constexpr double kPerWidth = 2.0;   // longest sides beside a thin face, in widths of it
constexpr double kPerRadius = 1.0;  // longest sides on a curve, in its radii: a hexagon
constexpr int kLeastSegments = 6;   // of a closed edge of another kind

/// Smallest radius of curvature of a surface, infinite for planes; of a cone at p.
double radius_of(const Surface& surface, const Vec3& p) {
  switch (surface.kind) {
    case Surface::Kind::Plane:
      break;
    case Surface::Kind::Cylinder:
    case Surface::Kind::Sphere:
      return surface.r1;
    case Surface::Kind::Torus:
      return surface.r2;
    case Surface::Kind::Cone: {
      const Vec3 local = rigid_inverse(surface.frame).apply(p);
      return std::hypot(local.x, local.y);
    }
  }
  return HUGE_VAL;
}

class Sizing {
 public:
  Sizing(const BoundaryModel& boundary, const SurfaceMeshOptions& options)
      : boundary_(boundary),
        longest_(options.edge_length),
        least_(options.least_length * options.edge_length) {}

  void set(SurfaceRemesher& remesher) const {
    const SurfaceMesh& mesh = remesher.mesh();
    std::vector<double>& lengths = remesher.lengths();
    lengths.assign(mesh.nodes.size(), longest_);
    for (std::size_t n = 0; n < lengths.size(); ++n)
      lengths[n] = std::min(lengths[n], curvature_length(mesh.supports[n], mesh.nodes[n]));
    grade(remesher);
  }

  /// Shortens sides beside thin faces and at short model edges: those that cannot be collapsed.
  void heed_thin_faces(SurfaceRemesher& remesher) const {
    const SurfaceMesh& mesh = remesher.mesh();
    std::vector<double>& lengths = remesher.lengths();
    for (const FaceFacet& f : mesh.facets)
      for (int i = 0; i < 3; ++i) {
        const std::int32_t a = f.nodes[i], b = f.nodes[(i + 1) % 3];
        const Support &sa = mesh.supports[a], &sb = mesh.supports[b];
        const bool rigid =
            f.edge[i] < 0 ? sa.kind >= Support::Kind::Edge && sb.kind >= Support::Kind::Edge
                          : sa.kind == Support::Kind::Vertex && sb.kind == Support::Kind::Vertex;
        if (!rigid) continue;
        const double width = distance(mesh.nodes[a], mesh.nodes[b]);
        const double length = std::max(kPerWidth * width, least_);
        for (const std::int32_t n : {a, b}) lengths[n] = std::min(lengths[n], length);
      }
    grade(remesher);
  }

  /// Halves the sides of facets that cut others; false where there are none.
  [[nodiscard]] bool heed_crossings(SurfaceRemesher& remesher, const Run& run) const {
    const SurfaceMesh& mesh = remesher.mesh();
    const auto crossings = surface_crossings(mesh, run);
    for (const auto& [s, t] : crossings)
      for (const std::int32_t k : {s, t}) {
        const Triangle& nodes = mesh.facets[k].nodes;
        double longest = 0;
        for (int i = 0; i < 3; ++i)
          longest =
              std::max(longest, distance(mesh.nodes[nodes[i]], mesh.nodes[nodes[(i + 1) % 3]]));
        for (const std::int32_t n : nodes)
          remesher.lengths()[n] = std::min(remesher.lengths()[n], 0.5 * longest);
      }
    grade(remesher);
    return !crossings.empty();
  }

 private:
  [[nodiscard]] double curvature_length(const Support& support, const Vec3& p) const {
    if (support.kind == Support::Kind::Face) {
      const Surface& surface = boundary_.faces[support.entity].surface;
      const double length = kPerRadius * radius_of(surface, p);
      return surface.kind == Surface::Kind::Cone ? std::max(length, least_) : length;
    }
    if (support.kind != Support::Kind::Edge) return HUGE_VAL;
    const BoundaryEdge& edge = boundary_.edges[support.entity];
    double length = edge.closed() ? edge.length / kLeastSegments : HUGE_VAL;
    if (edge.curve.kind == Curve::Kind::Circle)
      length = std::min(length, kPerRadius * edge.curve.radius);
    for (const int f : edge.faces) {
      const Surface& surface = boundary_.faces[f].surface;
      if (surface.kind != Surface::Kind::Cone)
        length = std::min(length, kPerRadius * radius_of(surface, p));
    }
    return length;
  }

  /// Lets lengths grow no faster than `kGrowth` from node to node (Dijkstra).
  static void grade(SurfaceRemesher& remesher) {
    const SurfaceMesh& mesh = remesher.mesh();
    std::vector<double>& lengths = remesher.lengths();
    std::vector<std::vector<std::int32_t>> around(mesh.nodes.size());
    for (const FaceFacet& f : mesh.facets)
      if (f.face >= 0)
        for (int i = 0; i < 3; ++i) around[f.nodes[i]].push_back(f.nodes[(i + 1) % 3]);
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t n = 0; n < lengths.size(); ++n)
      if (!around[n].empty()) queue.emplace(lengths[n], static_cast<std::int32_t>(n));
    while (!queue.empty()) {
      const auto [length, n] = queue.top();
      queue.pop();
      if (length > lengths[n]) continue;
      for (const std::int32_t m : around[n]) {
        const double most = length + kGrowth * distance(mesh.nodes[n], mesh.nodes[m]);
        if (most >= lengths[m]) continue;
        lengths[m] = most;
        queue.emplace(most, m);
      }
    }
  }

  const BoundaryModel& boundary_;
  double longest_, least_;
};

void remesh(SurfaceRemesher& remesher, int rounds, const Sizing& sizing) {
  for (int round = 0; round < rounds; ++round) {
    remesher.split_long();
    remesher.flip();
    remesher.collapse_short();
    remesher.flip();
    remesher.even_out();
    remesher.flip();
    remesher.compact();
    sizing.heed_thin_faces(remesher);
  }
}

}  // namespace

SurfaceMesh mesh_surface(const BoundaryModel& boundary, const SurfaceMeshOptions& options,
                         const Run& run) {
  SurfaceRemesher remesher(tessellated_surface(boundary), boundary, run);
  const Sizing sizing(boundary, options);
  sizing.set(remesher);
  remesh(remesher, kRounds, sizing);
  for (int round = 0; round < options.crossing_rounds; ++round) {
    if (!sizing.heed_crossings(remesher, run)) break;
    remesh(remesher, kRoundsPerCrossing, sizing);
  }
  return remesher.mesh();
}

}  // namespace remeshd
