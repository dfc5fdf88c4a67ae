#include "engine/remesh/finish/repair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/mesh/quality.h"
#include "engine/nodes/nearest.h"
#include "engine/optimise/recover.h"

namespace remeshd {

namespace {
constexpr double kAround = 1.0;   // x edge length: how far from a failure samples are looked at
constexpr double kClosest = 0.2;  // x edge length: no new node nearer than this to another

template <class Mesh>
bool is_sound(const Mesh& mesh, const Verification& verification) {
  for (const MeshFailure kind :
       {MeshFailure::BadFacet, MeshFailure::NonManifoldEdge, MeshFailure::NonManifoldVertex})
    if (verification.count(kind) > 0) return false;
  return std::ranges::all_of(mesh.tets,
                             [&](const Tet& t) { return volume_length(mesh.nodes, t) >= 0; });
}
}  // namespace

int insert_where_missing(NodeSet& nodes, std::span<const MeshDefect> defects,
                         const BoundaryModel& boundary, const Samples& samples,
                         const SizeField& sizes) {
  if (nodes.positions.empty()) return 0;  // a patch that nothing is in
  const double cell = kGridCell * sizes.grid_length();
  const NearestNode grid(nodes.positions, cell), grid_of_samples(samples.positions(), cell);
  std::vector<Sample> added;
  std::vector<Vec3> places;  // of those
  NearestNode grid_of_added(places, cell);
  const auto from_nodes2 = [&](const Vec3& p) {
    return norm2(p - nodes.positions[grid.nearest(p)]);
  };
  const auto room2 = [&](const Vec3& p, double of_nodes2) {
    const std::int32_t other = grid_of_added.nearest(p);
    return other < 0 ? of_nodes2 : std::fmin(of_nodes2, norm2(p - places[other]));
  };
  std::vector<double> of_sample(samples.points.size(), -1);  // once asked: from the nodes
  const auto place_for = [&](const MeshDefect& defect) -> std::optional<Sample> {
    const double edge_length = sizes(defect.place);
    const double closest2 = kClosest * kClosest * edge_length * edge_length;
    if (defect.kind == MeshFailure::MissingSegment) {
      const Support edge{Support::Kind::Edge, defect.entity};
      const Vec3 middle = project(boundary, edge, defect.place);
      if (room2(middle, from_nodes2(middle)) > closest2) return Sample{middle, 0, edge};
    }
    std::optional<Sample> best;
    double farthest = closest2;
    std::vector<std::int32_t> near;
    grid_of_samples.for_each_within(defect.place, kAround * edge_length,
                                    [&](std::int32_t s, double) { near.push_back(s); });
    std::ranges::sort(near);
    for (const std::int32_t k : near) {
      const Sample& s = samples.points[k];
      if (of_sample[k] < 0) of_sample[k] = from_nodes2(s.position);
      if (of_sample[k] <= farthest) continue;
      const double d = room2(s.position, of_sample[k]);
      if (d <= farthest) continue;
      farthest = d;
      best = s;
    }
    return best;
  };
  for (const MeshDefect& defect : defects) {
    const std::optional<Sample> place = place_for(defect);
    if (!place) continue;
    added.push_back(*place);
    places.push_back(place->position);
    const auto last = static_cast<std::int32_t>(places.size()) - 1;
    grid_of_added.follow(places, {&last, 1});
  }
  for (const Sample& s : added) nodes.add_new(s.position, s.support);
  return static_cast<int>(added.size());
}

std::vector<MeshDefect> nonconforming_facets(const PeeledMesh& mesh) {
  std::vector<MeshDefect> defects;
  for (const Vec3& place : mesh.nonconforming)
    defects.push_back(
        {MeshFailure::NonconformingFacet, -1, place, "a boundary facet on no model face"});
  return defects;
}

bool boundary_is_complete(const Verification& v) {
  return v.count(MeshFailure::NonManifoldEdge) + v.count(MeshFailure::NonManifoldVertex) +
             v.count(MeshFailure::MissingVertex) + v.count(MeshFailure::MissingSegment) +
             v.count(MeshFailure::NonconformingFacet) + v.count(MeshFailure::FacetOffFace) +
             v.count(MeshFailure::FaceArea) ==
         0;
}

bool can_be_improved(const TetMesh& mesh, const Verification& verification) {
  return is_sound(mesh, verification);
}
bool can_be_improved(const PagedMesh& mesh, const Verification& verification) {
  return is_sound(mesh, verification);
}

DelaunayMesh with_nodes_inserted(const DelaunayMesh& mesh, std::int32_t first_inserted,
                                 NodeSet& nodes, const BoundaryModel& boundary,
                                 const SizeField& sizes, const Run& run) {
  std::vector<std::uint8_t> holds(nodes.positions.size(), 0);
  std::fill_n(holds.begin(), first_inserted, 1);
  LiveMesh live(mesh, std::move(holds), false, run);
  recover_edges(nodes, boundary, live, {.sizes = sizes});
  return live.mesh();
}

}  // namespace remeshd
