#include "engine/local_fuse/prisms/parallel_prism_edges.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerance.h"
#include "engine/kernel/curve_points.h"

namespace remeshd {
namespace {

using kernel::BrepEdge;
using kernel::BrepFace;

}  // namespace

ParallelPrismEdges::ParallelPrismEdges(const Sweeps& sweeps, const PlanarArrangement& arrangement,
                                       const Slabs& slabs)
    : sweeps_(sweeps),
      arrangement_(arrangement),
      slabs_(slabs),
      vertex_(arrangement.nodes.size() * slabs.heights(), -1),
      level_(arrangement.pieces.size() * slabs.heights(), -1),
      upright_(arrangement.nodes.size() * (slabs.heights() + 1), -1),
      ends_at_(arrangement.nodes.size()) {
  for (int p = 0; p < static_cast<int>(arrangement.pieces.size()); ++p)
    for (const int n : {arrangement.pieces[p].a, arrangement.pieces[p].b}) ends_at_[n].push_back(p);
}

Vec3 ParallelPrismEdges::place(const Vec3& p, int height) const {
  return sweeps_.frame.apply({p.x, p.y, slabs_.z(height)});
}

int ParallelPrismEdges::vertex(int node, int height) {
  int& v = vertex_[static_cast<std::size_t>(node) * slabs_.heights() + height];
  if (v < 0) {
    v = static_cast<int>(brep_.vertices.size());
    brep_.vertices.push_back({place(arrangement_.nodes[node], height)});
  }
  return v;
}

int ParallelPrismEdges::add_line(int a, int b) {
  brep_.edges.push_back(line(a, b));
  return static_cast<int>(brep_.edges.size()) - 1;
}

int ParallelPrismEdges::add_arc(const ArrangementEdge& piece, int height) {
  const Vec3 start = arrangement_.nodes[piece.a] - piece.centre;
  const auto turned = [&](double t) {
    const double c = std::cos(t), s = std::sin(t);
    return Vec3{c * start.x - s * start.y, s * start.x + c * start.y, 0};
  };
  const auto at = [&](double t) { return place(piece.centre + turned(t), height); };
  BrepEdge edge;
  edge.kind = BrepEdge::Kind::Circle;
  edge.vertices = {vertex(piece.a, height), vertex(piece.b, height)};
  edge.length = piece.angle * piece.radius;
  edge.centre = place(piece.centre, height);
  edge.axis = axis();
  edge.radius = piece.radius;
  const Vec3 &first = brep_.vertices[edge.vertices[0]].position,
             &last = brep_.vertices[edge.vertices[1]].position;
  for (const int end : {0, 1})
    edge.tangents[end] = normalised(cross(edge.axis, (end == 0 ? first : last) - edge.centre));
  const int n = kernel::steps_of(piece.angle, kernel::kPointTurning);
  const int m = kernel::steps_of(piece.angle, kernel::kChordTurning);
  for (int i = 0; i <= n; ++i)
    edge.points.push_back(i == 0 ? first : i == n ? last : at(piece.angle * i / n));
  for (int i = 0; i <= m; ++i)
    edge.chain.push_back(i == 0   ? edge.vertices[0]
                         : i == m ? edge.vertices[1]
                                  : add_inner(at(piece.angle * i / m)));
  brep_.edges.push_back(std::move(edge));
  return static_cast<int>(brep_.edges.size()) - 1;
}
/// Adds a point of a polyline that is no vertex. Its number is negative until `finish`, which knows
/// how many vertices come before it.
int ParallelPrismEdges::add_inner(const Vec3& p) {
  inner_.push_back(p);
  return -static_cast<int>(inner_.size());
}

int ParallelPrismEdges::level(int p, int height) {
  int& e = level_[static_cast<std::size_t>(p) * slabs_.heights() + height];
  if (e >= 0) return e;
  const ArrangementEdge& piece = arrangement_.pieces[p];
  return e = piece.round ? add_arc(piece, height)
                         : add_line(vertex(piece.a, height), vertex(piece.b, height));
}

/// Whether, in a slab, line q continues line p straight at a node, with the same owners on both
/// sides and the same covers.
bool ParallelPrismEdges::straight(int node, int p, int q, int slab) const {
  const ArrangementEdge &a = arrangement_.pieces[p], &b = arrangement_.pieces[q];
  if (a.round || b.round || p == q) return false;
  const auto out = [&](const ArrangementEdge& piece) {
    return normalised(arrangement_.nodes[piece.a == node ? piece.b : piece.a] -
                      arrangement_.nodes[node]);
  };
  if (norm(out(a) + out(b)) > tolerance::kSameDirection) return false;
  const bool turned = (a.a == node) == (b.a == node);
  const auto covers = [&](const ArrangementEdge& piece, bool turn) {
    std::vector<ArrangementCover> active;
    for (ArrangementCover cover : piece.covers) {
      if (!slabs_.active(cover.sweep, slab)) continue;
      cover.left = cover.left != turn;
      active.push_back(cover);
    }
    return active;
  };
  const auto& left = turned ? slabs_.right(q, slab) : slabs_.left(q, slab);
  return slabs_.left(p, slab).owners == left.owners && covers(a, false) == covers(b, turned);
}

/// Whether there is an upright edge at a node in a slab: walls end there, and they are not just two
/// that continue each other straight.
bool ParallelPrismEdges::stands(int node, int slab) const {
  std::vector<int> walls;
  for (const int p : ends_at_[node])
    if (slabs_.wall(p, slab)) walls.push_back(p);
  return !walls.empty() && !(walls.size() == 2 && straight(node, walls[0], walls[1], slab));
}

/// Adds the upright edges at a node in some slabs.
void ParallelPrismEdges::add_upright(int node, int first, int last, std::vector<int>& edges) {
  const auto passes = [&](int height) {
    return std::ranges::all_of(ends_at_[node], [&](int p) { return slabs_.passes(p, height); });
  };
  for (int slab = first; slab <= last; ++slab) {
    if (!stands(node, slab)) continue;
    int low = slab, high = slab;
    while (low > 1 && passes(low - 1)) --low;
    while (high + 1 < slabs_.heights() && passes(high)) ++high;
    int& e = upright_[static_cast<std::size_t>(node) * (slabs_.heights() + 1) + low];
    if (e < 0) e = add_line(vertex(node, low - 1), vertex(node, high));
    edges.push_back(e);
    slab = high;
  }
}

/// Makes one line of two where nothing else ends between them.
void ParallelPrismEdges::join_lines() {
  std::vector<std::vector<int>> faces_at(brep_.edges.size()), edges_at(brep_.vertices.size());
  for (int f = 0; f < static_cast<int>(brep_.faces.size()); ++f)
    for (const int e : brep_.faces[f].edges) faces_at[e].push_back(f);
  for (int e = 0; e < static_cast<int>(brep_.edges.size()); ++e)
    if (!faces_at[e].empty())
      for (const int v : brep_.edges[e].vertices) edges_at[v].push_back(e);
  for (int v = 0; v < static_cast<int>(edges_at.size()); ++v) {
    if (edges_at[v].size() != 2) continue;
    const int keep = edges_at[v][0], drop = edges_at[v][1];
    BrepEdge &a = brep_.edges[keep], &b = brep_.edges[drop];
    if (keep == drop || a.kind != BrepEdge::Kind::Line || b.kind != BrepEdge::Kind::Line ||
        faces_at[keep] != faces_at[drop])
      continue;
    const int from = a.vertices[a.vertices[0] == v ? 1 : 0];
    const int to = b.vertices[b.vertices[0] == v ? 1 : 0];
    const Vec3& p = brep_.vertices[v].position;
    if (norm(normalised(brep_.vertices[from].position - p) +
             normalised(brep_.vertices[to].position - p)) > tolerance::kSameDirection)
      continue;
    a = line(from, to);
    std::ranges::replace(edges_at[to], drop, keep);
    for (const int f : faces_at[drop]) std::erase(brep_.faces[f].edges, drop);
    faces_at[drop].clear();
  }
}

kernel::Brep ParallelPrismEdges::finish(std::vector<BrepFace> faces) {
  brep_.faces = std::move(faces);
  join_lines();
  const int first = static_cast<int>(brep_.vertices.size());
  for (const kernel::BrepVertex& v : brep_.vertices) brep_.points.push_back(v.position);
  brep_.points.insert(brep_.points.end(), inner_.begin(), inner_.end());
  const auto number = [&](int& p) { p = p < 0 ? first - 1 - p : p; };
  for (BrepEdge& edge : brep_.edges) std::ranges::for_each(edge.chain, number);
  for (BrepFace& face : brep_.faces) {
    for (auto& triangle : face.triangles) std::ranges::for_each(triangle, number);
    std::ranges::sort(face.edges);
  }
  return std::move(brep_);
}

}  // namespace remeshd
