#include "engine/boundary/control_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/base/error.h"
#include "engine/boundary/material.h"
#include "engine/mesh/quality.h"

namespace remeshd {
namespace {

struct Octree {
  int depth = 5;             ///< another level: queries 20 ns faster, building 10 ms slower
  int steps = 1 << depth;    ///< finest cells along each axis
  std::size_t few_tets = 4;  ///< no cell with so few tets is divided
};
constexpr Octree kOctree;
// Relative. TetGen takes triangles within 0.1 degree of one plane for coplanar, which changes the
// volume of tool2-d by 2.6e-7.
constexpr double kVolumeTolerance = 1e-5;
enum CellState : std::int32_t { kOutside = -1, kInside = -2 };  // smaller values: lists of tets

/// Volume within an outward oriented closed surface, by the divergence theorem.
double enclosed_volume(const kernel::TetGenSurface& surface) {
  const Vec3 o = surface.points.front();
  double six = 0;
  for (const auto& [a, b, c] : surface.triangles)
    six += dot(cross(surface.points[a] - o, surface.points[b] - o), surface.points[c] - o);
  return six / 6;
}

double extent(const Vec3& normal, const Vec3& half) {
  return std::fabs(normal.x) * half.x + std::fabs(normal.y) * half.y + std::fabs(normal.z) * half.z;
}

bool apart(const Box& box, const Vec3& centre, const Vec3& half, double margin) {
  return box.lo.x > centre.x + half.x + margin || box.hi.x < centre.x - half.x - margin ||
         box.lo.y > centre.y + half.y + margin || box.hi.y < centre.y - half.y - margin ||
         box.lo.z > centre.z + half.z + margin || box.hi.z < centre.z - half.z - margin;
}

/// Facets that belong to one tet only.
std::vector<Triangle> boundary_facets(const TetMesh& mesh) {
  struct Facet {
    Triangle sorted, facet;
  };
  std::vector<Facet> all;
  for (const Tet& tet : mesh.tets)
    for (const auto& [i, j, k] : kTetFacets) {
      Facet f{{}, {tet[i], tet[j], tet[k]}};
      f.sorted = f.facet;
      std::ranges::sort(f.sorted);
      all.push_back(f);
    }
  std::ranges::stable_sort(all, {}, &Facet::sorted);
  std::vector<Triangle> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool shared = (i > 0 && all[i - 1].sorted == all[i].sorted) ||
                        (i + 1 < all.size() && all[i + 1].sorted == all[i].sorted);
    if (!shared) out.push_back(all[i].facet);
  }
  return out;
}

}  // namespace

struct ControlMesh::Scene {
  std::vector<Box> tet_boxes, facet_boxes;
  std::vector<Plane> facet_planes;
  double margin;  ///< far above rounding: what touches a cell counts as in it

  [[nodiscard]] bool facet_touches(std::int32_t t, const Vec3& centre, const Vec3& half) const {
    const auto& [normal, offset] = facet_planes[t];
    return !apart(facet_boxes[t], centre, half, margin) &&
           std::fabs(dot(normal, centre) + offset) <= extent(normal, half) + margin;
  }
  [[nodiscard]] bool tet_touches(std::int32_t t, const TetPlanes& planes, const Vec3& centre,
                                 const Vec3& half) const {
    return !apart(tet_boxes[t], centre, half, margin) &&
           std::ranges::all_of(planes, [&](const Plane& plane) {
             return dot(plane.normal, centre) + plane.offset + extent(plane.normal, half) >=
                    -margin;
           });
  }
};

kernel::TetGenSurface joined_surface(const BoundaryModel& boundary) {
  kernel::TetGenSurface surface;
  std::map<std::array<double, 3>, std::int32_t> number;
  for (const BoundaryFace& face : boundary.faces) {
    std::vector<std::int32_t> of_point;
    for (const Vec3& p : face.points) {
      const auto [it, fresh] =
          number.emplace(std::array{p.x, p.y, p.z}, static_cast<std::int32_t>(number.size()));
      if (fresh) surface.points.push_back(p);
      of_point.push_back(it->second);
    }
    for (const auto& [a, b, c] : face.triangles)
      surface.triangles.push_back({of_point[a], of_point[b], of_point[c]});
  }
  return surface;
}

ControlMesh ControlMesh::build(const BoundaryModel& boundary, const Run& run,
                               const kernel::TetGenLimits& limits) {
  const kernel::TetGenSurface surface = joined_surface(boundary);
  if (surface.triangles.empty()) throw error::tetgen_refused("it has no triangles");
  kernel::TetGenMesh all = kernel::run_tetgen(surface, limits, run);

  ControlMesh out;
  for (const Vec3& p : surface.points) out.bounds_.add(p);
  out.tolerance_ = 1e-12 * out.bounds_.diagonal();
  out.mesh_.tets = tets_in_material(all, surface);
  out.mesh_.nodes = std::move(all.mesh.nodes);
  out.add_planes();
  const double expected = enclosed_volume(surface);
  if (std::fabs(out.volume_ - expected) > kVolumeTolerance * std::fabs(expected))
    throw error::tetgen_refused("the surface is not closed, or cuts itself");

  Scene scene;
  scene.margin = 1e-9 * out.bounds_.diagonal();
  for (const Tet& tet : out.mesh_.tets) scene.tet_boxes.push_back(box_of(out.mesh_.nodes, tet));
  const std::vector<Triangle> facets = boundary_facets(out.mesh_);
  for (const Triangle& t : facets) {
    const Vec3& a = out.mesh_.nodes[t[0]];
    const Vec3 n = cross(out.mesh_.nodes[t[1]] - a, out.mesh_.nodes[t[2]] - a);
    const double length = norm(n);
    const Vec3 unit = length > 0 ? n / length : Vec3{};  // a flat one then counts by its box alone
    scene.facet_planes.push_back({unit, -dot(unit, a)});
    scene.facet_boxes.push_back(box_of(out.mesh_.nodes, t));
  }
  std::vector<std::int32_t> tets(out.mesh_.tets.size()), facet_numbers(facets.size());
  std::iota(tets.begin(), tets.end(), 0);
  std::iota(facet_numbers.begin(), facet_numbers.end(), 0);
  const Vec3 size = out.bounds_.hi - out.bounds_.lo;
  out.steps_per_length_ = {kOctree.steps / size.x, kOctree.steps / size.y, kOctree.steps / size.z};
  out.nodes_.push_back(kOutside);
  out.leaf_first_.push_back(0);
  run.poll();
  out.divide(scene, 0, 0.5 * (out.bounds_.lo + out.bounds_.hi), 0.5 * size, 0, tets, facet_numbers);
  return out;
}

void ControlMesh::add_planes() {
  std::vector<Tet> sound;
  for (const Tet& tet : mesh_.tets) {
    const double volume = tet_volume(mesh_.nodes, tet);
    TetPlanes planes;
    double most_area = 0;
    for (int i = 0; i < 4; ++i) {
      const Vec3& a = mesh_.nodes[tet[kTetFacets[i][0]]];
      const Vec3& b = mesh_.nodes[tet[kTetFacets[i][1]]];
      const Vec3& c = mesh_.nodes[tet[kTetFacets[i][2]]];
      const Vec3 n = cross(b - a, c - a);
      most_area = std::max(most_area, norm(n) / 2);
      const Vec3 in = -n / norm(n);
      planes[i] = {in, -dot(in, a)};
    }
    // A tet flatter than the tolerance lies within that of its neighbours.
    if (3 * volume <= tolerance_ * most_area) continue;
    volume_ += volume;
    sound.push_back(tet);
    planes_.push_back(planes);
  }
  mesh_.tets = std::move(sound);
}

bool ControlMesh::in_tet(std::int32_t tet, const Vec3& p) const {
  return std::ranges::all_of(planes_[tet], [&](const Plane& plane) {
    return dot(plane.normal, p) + plane.offset >= -tolerance_;
  });
}

void ControlMesh::divide(const Scene& scene, std::size_t node, const Vec3& centre, const Vec3& half,
                         int depth, const std::vector<std::int32_t>& tets,
                         const std::vector<std::int32_t>& facets) {
  if (facets.empty()) {  // all inside or all outside
    const bool in = std::ranges::any_of(tets, [&](std::int32_t t) { return in_tet(t, centre); });
    nodes_[node] = in ? kInside : kOutside;
    return;
  }
  if (tets.size() <= kOctree.few_tets || depth == kOctree.depth) {
    if (tets.empty()) return;  // outside, touched by the surface
    leaf_tets_.insert(leaf_tets_.end(), tets.begin(), tets.end());
    nodes_[node] = kInside - static_cast<std::int32_t>(leaf_first_.size());
    leaf_first_.push_back(static_cast<std::int32_t>(leaf_tets_.size()));
    return;
  }
  const std::size_t children = nodes_.size();
  nodes_[node] = static_cast<std::int32_t>(children);
  nodes_.resize(children + 8, kOutside);
  const Vec3 h = 0.5 * half;
  for (int child = 0; child < 8; ++child) {
    const Vec3 c{centre.x + ((child & 1) != 0 ? h.x : -h.x),
                 centre.y + ((child & 2) != 0 ? h.y : -h.y),
                 centre.z + ((child & 4) != 0 ? h.z : -h.z)};
    std::vector<std::int32_t> some_tets, some_facets;
    for (const std::int32_t t : tets)
      if (scene.tet_touches(t, planes_[t], c, h)) some_tets.push_back(t);
    for (const std::int32_t t : facets)
      if (scene.facet_touches(t, c, h)) some_facets.push_back(t);
    divide(scene, children + static_cast<std::size_t>(child), c, h, depth + 1, some_tets,
           some_facets);
  }
}

bool ControlMesh::inside(const Vec3& p) const {
  if (!bounds_.contains(p, tolerance_)) return false;
  const auto step = [](double place) {
    return static_cast<unsigned>(std::clamp(place, 0.0, kOctree.steps - 0.5));
  };
  const unsigned x = step((p.x - bounds_.lo.x) * steps_per_length_.x);
  const unsigned y = step((p.y - bounds_.lo.y) * steps_per_length_.y);
  const unsigned z = step((p.z - bounds_.lo.z) * steps_per_length_.z);
  std::int32_t node = nodes_[0];
  for (int bit = kOctree.depth - 1; node >= 0; --bit)
    node = nodes_[static_cast<std::size_t>(node) + (x >> bit & 1U) + 2 * (y >> bit & 1U) +
                  4 * (z >> bit & 1U)];
  if (node == kOutside) return false;
  if (node == kInside) return true;
  const auto leaf = static_cast<std::size_t>(kInside - node);
  for (std::int32_t i = leaf_first_[leaf - 1]; i < leaf_first_[leaf]; ++i)
    if (in_tet(leaf_tets_[i], p)) return true;
  return false;
}

}  // namespace remeshd
