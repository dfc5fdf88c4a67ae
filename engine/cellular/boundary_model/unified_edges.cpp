#include "engine/cellular/boundary_model/unified_edges.h"

#include <utility>

#include "engine/base/union_find.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;

bool is_apex(const Surface& surface, const Vec3& p, double tolerance) {
  if (surface.kind != Surface::Kind::Cone || surface.r2 == 0) return false;
  return distance(p, surface.frame.apply({0, 0, -surface.r1 / surface.r2})) < tolerance;
}

/// Joins faces of one surface across the edges between them; all other edges bound a change of
/// surface.
void unify_faces(const Brep& brep, const std::vector<SelectedFace>& faces, double tolerance,
                 UnifiedEdges& out) {
  const int count = static_cast<int>(brep.faces.size());
  std::vector<Box> boxes(brep.faces.size());
  for (int f = 0; f < count; ++f)
    if (faces[f].selected)
      for (const auto& triangle : brep.faces[f].triangles)
        boxes[f].add(box_of(brep.points, triangle));
  UnionFind groups(brep.faces.size());
  for (std::size_t e = 0; e < brep.edges.size(); ++e) {
    const std::vector<int>& at = out.faces_at_edge[e];
    if (at.empty()) continue;
    if (at.size() != 2) {
      out.edge[e] = 1;
      continue;
    }
    const int f = at[0], g = at[1];
    if (f == g) continue;
    Box where = boxes[f];
    where.add(boxes[g]);
    const bool same = faces[f].side == faces[g].side &&
                      same_surface(faces[f].surface, faces[g].surface, where, tolerance);
    if (same && faces[f].group == faces[g].group) {
      groups.join(f, g);
    } else {
      out.edge[e] = 1;
      out.rim[e] = same ? 1 : 0;
    }
  }
  out.face_group.assign(brep.faces.size(), -1);
  for (int f = 0; f < count; ++f)
    if (faces[f].selected)
      out.face_group[f] = groups.find(f) == f ? out.groups++ : out.face_group[groups.find(f)];
}

/// Vertices where edges end or turn, and apexes of cones.
void find_vertices(const Brep& brep, const std::vector<SelectedFace>& faces, double tolerance,
                   UnifiedEdges& out) {
  struct End {
    int edge, end;
  };
  std::vector<std::vector<End>> ends(brep.vertices.size());
  for (int e = 0; e < static_cast<int>(brep.edges.size()); ++e)
    if (out.edge[e])
      for (const int end : {0, 1}) ends[brep.edges[e].vertices[end]].push_back({e, end});
  for (std::size_t v = 0; v < ends.size(); ++v) {
    if (ends[v].size() == 2) {
      const auto [a, b] = std::pair(ends[v][0], ends[v][1]);
      out.vertex[v] =
          out.rim[a.edge] == out.rim[b.edge] &&
                  continues(brep.edges[a.edge], a.end, brep.edges[b.edge], b.end, tolerance)
              ? 0
              : 1;
    } else {
      out.vertex[v] = ends[v].empty() ? 0 : 1;
    }
  }
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    if (!faces[f].selected || faces[f].surface.kind != Surface::Kind::Cone) continue;
    for (const int e : brep.faces[f].edges)
      for (const int v : brep.edges[e].vertices)
        if (ends[v].empty() && is_apex(faces[f].surface, brep.vertices[v].position, tolerance))
          out.vertex[v] = 1;
  }
}

}  // namespace

double kernel_tolerance(const Brep& brep) { return 1e-6 / brep.scale; }

bool continues(const BrepEdge& a, int end_a, const BrepEdge& b, int end_b, double tolerance) {
  if (a.kind != b.kind) return false;
  const Vec3 out = end_a == 1 ? a.tangents[1] : -a.tangents[0];
  const Vec3 in = end_b == 0 ? b.tangents[0] : -b.tangents[1];
  // Curves of intersection are approximated, so are their tangents.
  const double turning = a.kind == BrepEdge::Kind::Other ? 1e-2 : 1e-6;
  if (norm(out - in) > turning) return false;
  if (a.kind != BrepEdge::Kind::Circle) return true;
  return distance(a.centre, b.centre) < tolerance && std::fabs(a.radius - b.radius) < tolerance;
}

UnifiedEdges find_unified_edges(const Brep& brep, const std::vector<SelectedFace>& faces) {
  UnifiedEdges out;
  const double tolerance = kernel_tolerance(brep);
  out.faces_at_edge.resize(brep.edges.size());
  out.edge.assign(brep.edges.size(), 0);
  out.rim.assign(brep.edges.size(), 0);
  out.vertex.assign(brep.vertices.size(), 0);
  for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f)
    if (faces[f].selected)
      for (const int e : brep.faces[f].edges) out.faces_at_edge[e].push_back(f);
  unify_faces(brep, faces, tolerance, out);
  find_vertices(brep, faces, tolerance, out);
  return out;
}

}  // namespace remeshd
