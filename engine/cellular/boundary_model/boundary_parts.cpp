#include "engine/cellular/boundary_model/boundary_parts.h"

#include <algorithm>
#include <numeric>

#include "engine/cellular/boundary_model/tolerant_order.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/cellular/changes.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;

constexpr double kBulge = 0.05;  // x a chord: more than an arc of 6 degrees stands off its chord

/// The indices that are used, sorted by rank.
template <typename Ranks>
std::vector<int> order_of(const std::vector<char>& used, const Ranks& ranks) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(used.size()); ++i)
    if (used[i]) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](int i) { return ranks[i]; });
  return order;
}

/// Directs an edge from its lower vertex to its higher; a closed one from its start towards the
/// smaller (`lies_before`) of the two points next to it.
void direct(BrepEdge& edge) {
  const auto [first, last] = edge.vertices;
  if (first != last ? first < last : !lies_before(*(edge.points.end() - 2), edge.points[1])) return;
  std::swap(edge.vertices[0], edge.vertices[1]);
  edge.tangents = {-edge.tangents[1], -edge.tangents[0]};
  edge.axis = -edge.axis;
  std::ranges::reverse(edge.points);
  std::ranges::reverse(edge.chain);
  std::ranges::reverse(edge.samples);
  for (auto& sample : edge.samples) sample[1] = -sample[1];
}

std::array<double, 3> coordinates(const Vec3& p) { return {p.x, p.y, p.z}; }

void order_vertices(Brep& brep, const std::vector<char>& used_edge, double gap) {
  std::vector<char> used(brep.vertices.size(), 0);
  for (std::size_t e = 0; e < brep.edges.size(); ++e)
    if (used_edge[e])
      for (const int v : brep.edges[e].vertices) used[v] = 1;
  std::vector<std::array<double, 3>> keys;
  for (const kernel::BrepVertex& v : brep.vertices) keys.push_back(coordinates(v.position));
  const std::vector<int> renumber =
      rearrange(brep.vertices, order_of(used, tolerant_ranks(keys, gap)));
  for (std::size_t e = 0; e < brep.edges.size(); ++e) {
    if (!used_edge[e]) continue;
    for (int& v : brep.edges[e].vertices) v = renumber[v];
    direct(brep.edges[e]);
  }

  // Points: the vertices first, then edge by edge, then face by face.
  std::vector<Vec3> points;
  for (const kernel::BrepVertex& v : brep.vertices) points.push_back(v.position);
  std::vector<int> point(brep.points.size(), -1);
  for (std::size_t v = 0; v < renumber.size(); ++v) point[v] = renumber[v];
  const auto number = [&](int& p) {
    if (point[p] < 0) {
      point[p] = static_cast<int>(points.size());
      points.push_back(brep.points[p]);
    }
    p = point[p];
  };
  for (std::size_t e = 0; e < brep.edges.size(); ++e)
    if (used_edge[e])
      for (int& p : brep.edges[e].chain) number(p);
  for (BrepFace& face : brep.faces)
    for (auto& triangle : face.triangles)
      for (int& p : triangle) number(p);
  brep.points = std::move(points);
}

void order_edges(Brep& brep, const std::vector<char>& used, double gap) {
  std::vector<std::array<double, 5>> keys;
  for (const BrepEdge& edge : brep.edges) {
    const Vec3& m = edge.points[edge.points.size() / 2];
    const auto ends = std::minmax(edge.vertices[0], edge.vertices[1]);
    // Vertex numbers, spread by more than the gap, so that no two get the same rank.
    keys.push_back({m.x, m.y, m.z, 2 * gap * ends.first, 2 * gap * ends.second});
  }
  const std::vector<int> renumber =
      rearrange(brep.edges, order_of(used, tolerant_ranks(keys, gap)));
  for (BrepFace& face : brep.faces) {
    for (int& e : face.edges) e = renumber[e];
    std::ranges::sort(face.edges);
  }
}

void order_faces(BoundaryParts& parts, double gap) {
  std::vector<std::array<double, 4>> keys;
  for (const BrepFace& face : parts.brep.faces)
    keys.push_back({face.centroid.x, face.centroid.y, face.centroid.z, std::sqrt(face.area)});
  const auto ranks = tolerant_ranks(keys, gap);
  std::vector<int> order(parts.pieces.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int a, int b) {
    return ranks[a] != ranks[b] ? ranks[a] < ranks[b]
                                : parts.brep.faces[a].edges < parts.brep.faces[b].edges;
  });
  rearrange(parts.brep.faces, order);
  rearrange(parts.pieces, order);
}

/// An estimate, from above, of how far a face stands off its triangles.
double bulge(const Brep& brep, const BrepFace& face, const Surface& surface) {
  if (surface.kind == Surface::Kind::Plane) return 0;
  double off = 0;
  for (const auto& [a, b, c] : face.triangles) {
    const Vec3 &p = brep.points[a], &q = brep.points[b], &r = brep.points[c];
    for (const Vec3& middle : {0.5 * (p + q), 0.5 * (q + r), 0.5 * (r + p), (p + q + r) / 3})
      off = std::max(off, std::fabs(signed_distance(surface, middle)));
  }
  return 2 * off;
}

}  // namespace

Box box_of(const BrepEdge& edge) {
  Box box;
  double chord = 0;
  for (std::size_t i = 0; i < edge.points.size(); ++i) {
    box.add(edge.points[i]);
    if (i > 0) chord = std::max(chord, distance(edge.points[i - 1], edge.points[i]));
  }
  return edge.kind == BrepEdge::Kind::Line ? box : grown(box, kBulge * chord);
}

Box box_of(const Brep& brep, const BrepFace& face, const Surface& surface) {
  Box box;
  for (const int e : face.edges) box.add(box_of(brep.edges[e]));
  if (surface.kind == Surface::Kind::Plane) return box;
  for (const auto& triangle : face.triangles) box.add(box_of(brep.points, triangle));
  return grown(box, bulge(brep, face, surface));
}

bool touches(const std::vector<Box>& boxes, const BrepEdge& edge) {
  const double by = edge.kind == BrepEdge::Kind::Line ? 0 : kBulge;
  for (std::size_t i = 1; i < edge.points.size(); ++i) {
    const Vec3 &a = edge.points[i - 1], &b = edge.points[i];
    if (touch(boxes, grown(box_of(std::array{a, b}), by * distance(a, b)))) return true;
  }
  return false;
}

bool touches(const std::vector<Box>& boxes, const Brep& brep, const BrepFace& face,
             const Surface& surface) {
  const double by = bulge(brep, face, surface);
  return std::ranges::any_of(face.triangles, [&](const std::array<int, 3>& triangle) {
    return touch(boxes, grown(box_of(brep.points, triangle), by));
  });
}

bool looks_along(const Brep& brep, const BrepFace& face, const Surface& surface) {
  double along = 0;  // of all triangles, for some may be slivers
  for (const auto& [a, b, c] : face.triangles)
    along += dot(cross(brep.points[b] - brep.points[a], brep.points[c] - brep.points[a]),
                 normal(surface, brep.points[a]));
  return along > 0;
}

void put_edges_in_canonical_order(Brep& brep) {
  const double gap = kOrderGap * kernel_tolerance(brep);
  std::vector<char> used(brep.edges.size(), 0);
  for (const BrepFace& face : brep.faces)
    for (const int e : face.edges) used[e] = 1;
  order_vertices(brep, used, gap);
  order_edges(brep, used, gap);
}

void put_in_canonical_order(BoundaryParts& parts) {
  put_edges_in_canonical_order(parts.brep);
  order_faces(parts, kOrderGap * kernel_tolerance(parts.brep));
}

BoundaryParts boundary_parts(const Brep& brep, const std::vector<BoundaryPiece>& pieces) {
  BoundaryParts out;
  out.brep.edges = brep.edges;
  out.brep.vertices = brep.vertices;
  out.brep.points = brep.points;
  out.brep.reference = brep.reference;
  out.brep.scale = brep.scale;
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    if (!pieces[f].boundary) continue;
    BrepFace& face = out.brep.faces.emplace_back(brep.faces[f]);
    BoundaryPiece& piece = out.pieces.emplace_back(pieces[f]);
    if (!piece.outward) {
      face.turn_over();
      piece.outward = true;
    }
    face.cells = {0, -1};
    piece.box = box_of(brep, brep.faces[f], piece.surface);
  }
  put_in_canonical_order(out);
  return out;
}

}  // namespace remeshd
