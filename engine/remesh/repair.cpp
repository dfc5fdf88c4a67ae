#include "engine/remesh/repair.h"

#include "engine/nodes/nearest.h"
#include "engine/optimise/recover.h"

namespace remeshd {

namespace {
constexpr double kAround = 1.0;   // x edge length: how far from a failure samples are looked at
constexpr double kClosest = 0.2;  // x edge length: no new node nearer than this to another
}  // namespace

int insert_where_missing(NodeSet& nodes, const Verification& verification, const Samples& samples,
                         double edge_length) {
  const NearestNode grid(nodes.positions, 0.8 * edge_length);
  std::vector<Vec3> added;
  for (const MeshDefect& defect : verification.failures) {
    const Sample* best = nullptr;
    double farthest = kClosest * edge_length * kClosest * edge_length;
    for (const Sample& s : samples.points) {
      if (norm2(s.position - defect.place) > kAround * kAround * edge_length * edge_length)
        continue;
      double d = norm2(s.position - nodes.positions[grid.nearest(s.position)]);
      for (const Vec3& p : added) d = std::fmin(d, norm2(s.position - p));
      if (d > farthest) {
        farthest = d;
        best = &s;
      }
    }
    if (!best) continue;
    added.push_back(best->position);
    nodes.add_new(best->position, best->support);
  }
  return static_cast<int>(added.size());
}

kernel::Delaunay triangulate_anew(NodeSet& nodes, const BoundaryModel& boundary, double edge_length,
                                  const Run& run) {
  LiveMesh live(kernel::Delaunay(boundary.bounds), {}, run);
  recover_edges(nodes, boundary, live, {.edge_length = edge_length});
  return live.mesh();
}

}  // namespace remeshd
