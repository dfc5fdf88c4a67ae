#include "engine/improve/boundary_rules.h"

#include <algorithm>
#include <cmath>

#include "engine/boundary/edge_chains.h"

namespace remeshd {
namespace {

/// A facet is upright on its face while the normals differ by less than 60 degrees; meshes that
/// resolve a curved face at all stay far below.
constexpr double kUprightCosine = 0.5;

std::pair<std::int32_t, std::int32_t> ordered(std::int32_t a, std::int32_t b) {
  return a < b ? std::pair{a, b} : std::pair{b, a};
}

/// `facets`: those that contain the node, of each of its tets. Keeps those of one tet alone.
void keep_facets_of_one_tet(std::int32_t node, std::vector<Triangle>& facets) {
  const auto far_edge = [node](const Triangle& facet) {
    const int i = facet[0] == node ? 0 : facet[1] == node ? 1 : 2;
    return ordered(facet[(i + 1) % 3], facet[(i + 2) % 3]);
  };
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  edges.reserve(facets.size());
  for (const Triangle& facet : facets) edges.push_back(far_edge(facet));
  std::sort(edges.begin(), edges.end());
  std::erase_if(facets, [&](const Triangle& facet) {
    const auto [first, last] = std::equal_range(edges.begin(), edges.end(), far_edge(facet));
    return last - first > 1;
  });
}

}  // namespace

BoundaryRules::BoundaryRules(const BoundaryModel& boundary, std::span<const Support> supports,
                             const LocalMesh& mesh, double chord_tolerance)
    : boundary_(boundary),
      supports_(supports),
      mesh_(mesh),
      chord_tolerance_(chord_tolerance),
      faces_(boundary, supports) {
  for (const auto& chain : edge_chains(boundary, supports, mesh.nodes()))
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      segments_.push_back(ordered(chain[i].node, chain[i + 1].node));
  std::sort(segments_.begin(), segments_.end());
}

bool BoundaryRules::on_model_edge(std::int32_t a, std::int32_t b) const {
  const auto curve = [&](std::int32_t n) {
    return supports_[n].kind == Support::Kind::Edge || supports_[n].kind == Support::Kind::Vertex;
  };
  return curve(a) && curve(b) &&
         std::binary_search(segments_.begin(), segments_.end(), ordered(a, b));
}

int BoundaryRules::face_of(const Triangle& facet) const {
  const std::vector<Vec3>& p = mesh_.nodes();
  return faces_.face_of(facet, p[facet[0]], p[facet[1]], p[facet[2]]);
}

bool BoundaryRules::upright(int face, const Vec3& a, const Vec3& b, const Vec3& c) const {
  const Vec3 n = cross(b - a, c - a);
  const double along = dot(n, faces_.outward(face, (a + b + c) / 3.0));
  return along > 0 && along * along >= kUprightCosine * kUprightCosine * norm2(n);
}

bool BoundaryRules::stays_along(int face, const std::array<Vec3, 3>& now,
                                const std::array<Vec3, 3>& then) const {
  return boundary_.faces[face].surface.kind == Surface::Kind::Plane ||
         faces_.lies_along(face, then) || !faces_.lies_along(face, now);
}

bool BoundaryRules::may_swap(std::int32_t a, std::int32_t b, const EdgeRing& ring) const {
  const std::int32_t first = ring.node[0];
  const std::int32_t last = ring.node[ring.nodes - 1];
  if (interior(a) || interior(b) || interior(first) || interior(last)) return false;
  if (mesh_.locked(first) && mesh_.locked(last)) return false;
  const int face = face_of({a, first, b});
  if (face < 0 || face_of({a, b, last}) != face) return false;
  if (on_model_edge(a, b)) return false;
  if (ring.tets == 1) {
    // The lone tet is peeled: its inner edge comes to the surface, where it must not lie yet.
    EdgeRing inner;
    if (!mesh_.ring(first, last, EdgeRing::kMaxTets, inner) || !inner.closed) return false;
  } else if (mesh_.joined(first, last)) {
    return false;
  }
  const Vec3& pa = mesh_.node(a);
  const Vec3& pb = mesh_.node(b);
  const Vec3& pf = mesh_.node(first);
  const Vec3& pl = mesh_.node(last);
  if (!upright(face, pa, pf, pl) || !upright(face, pb, pl, pf)) return false;
  if (!stays_along(face, {pa, pf, pb}, {pa, pf, pl}) ||
      !stays_along(face, {pa, pb, pl}, {pb, pl, pf}))
    return false;
  const double before = faces_.deviation(face, 0.5 * (pa + pb));
  const double after = faces_.deviation(face, 0.5 * (pf + pl));
  return after <= before + chord_tolerance_ * distance(pf, pl);
}

bool BoundaryRules::facets_at(std::int32_t node, std::vector<Triangle>& out) const {
  out.clear();
  if (supports_[node].kind == Support::Kind::Vertex || mesh_.locked(node)) return false;
  const auto tets = mesh_.tets_of(node);
  if (interior(node)) {
    // A sphere of T triangles has T / 2 + 2 corners; the link of a node on the boundary has more.
    std::vector<std::int32_t> link;
    link.reserve(3 * tets.size());
    for (const std::int32_t t : tets)
      for (const std::int32_t n : mesh_.tet(t))
        if (n != node) link.push_back(n);
    std::sort(link.begin(), link.end());
    const auto corners = std::unique(link.begin(), link.end()) - link.begin();
    return 2 * corners == static_cast<std::ptrdiff_t>(tets.size()) + 4;
  }
  for (const std::int32_t t : tets) {
    const Tet& tet = mesh_.tet(t);
    for (int i = 0; i < 4; ++i) {
      if (tet[i] == node) continue;
      const Triangle facet{tet[kTetFacets[i][0]], tet[kTetFacets[i][1]], tet[kTetFacets[i][2]]};
      if (!interior(facet[0]) && !interior(facet[1]) && !interior(facet[2])) out.push_back(facet);
    }
  }
  keep_facets_of_one_tet(node, out);
  return std::ranges::none_of(out, [&](const Triangle& facet) { return face_of(facet) < 0; });
}

bool BoundaryRules::may_move(std::int32_t node, const Vec3& position,
                             std::span<const Triangle> facets) const {
  for (const Triangle& facet : facets) {
    const int face = face_of(facet);
    if (boundary_.faces[face].surface.kind == Surface::Kind::Plane) {
      // In its plane a facet only turns over together with its tet.
      continue;
    }
    std::array<Vec3, 3> now;
    std::array<Vec3, 3> then;
    for (int i = 0; i < 3; ++i) {
      now[i] = mesh_.node(facet[i]);
      then[i] = facet[i] == node ? position : now[i];
    }
    if (!upright(face, then[0], then[1], then[2])) return false;
    const double before = faces_.deviation(face, (now[0] + now[1] + now[2]) / 3.0);
    const double after = faces_.deviation(face, (then[0] + then[1] + then[2]) / 3.0);
    const double length = std::sqrt(
        std::max({norm2(then[1] - then[0]), norm2(then[2] - then[1]), norm2(then[0] - then[2])}));
    if (after > before + chord_tolerance_ * length || !stays_along(face, now, then)) return false;
  }
  return true;
}

Vec3 BoundaryRules::settle(std::int32_t node, const Vec3& p) const {
  return interior(node) ? p : project(boundary_, supports_[node], p);
}

}  // namespace remeshd
