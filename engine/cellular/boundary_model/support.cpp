#include "engine/cellular/boundary_model/support.h"

#include <algorithm>

#include "engine/base/angle.h"
#include "engine/cellular/boundary_model/edge_curve.h"

namespace remeshd {
namespace {

constexpr int kSlides = 8;

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 d = b - a;
  const double t = dot(p - a, d) / norm2(d);
  if (t <= 0) return a;
  if (t >= 1) return b;
  return a + t * d;
}

Vec3 nearest_on_circle(const BoundaryEdge& edge, const Vec3& p) {
  const Curve& circle = edge.curve;
  const Vec3 axis = circle.direction;
  const Vec3 start = edge.points.front() - circle.origin;
  Vec3 out = p - circle.origin;
  out = out - dot(out, axis) * axis;
  // On the axis all points of the circle are equally near: take the start.
  if (norm(out) <= 1e-14 * circle.radius) return edge.points.front();
  if (edge.closed() && edge.start < 0) return circle.origin + circle.radius * normalised(out);
  const Vec3 u = normalised(start - dot(start, axis) * axis);
  double angle = std::atan2(dot(out, cross(axis, u)), dot(out, u));
  if (angle < 0) angle += kTurn;
  const double whole = edge.length / circle.radius;
  if (angle <= whole) return circle.origin + circle.radius * normalised(out);
  return angle - whole < kTurn - angle ? edge.points.back() : edge.points.front();
}

Vec3 nearest_on_polyline(const BoundaryModel& boundary, const BoundaryEdge& edge, const Vec3& p) {
  Vec3 best = edge.points.front();
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
    const Vec3 q = nearest_on_segment(edge.points[i], edge.points[i + 1], p);
    if (const double d = distance(p, q); d < nearest) {
      nearest = d;
      best = q;
    }
  }
  const bool at_end = best == edge.points.front() || best == edge.points.back();
  if ((at_end && edge.start >= 0) || edge.faces.size() != 2) return best;
  // The foot on a chord is not the foot on the curve: slide along the tangent until p lies square
  // to it, so that projecting a second time changes nothing.
  const Surface& a = boundary.faces[edge.faces[0]].surface;
  const Surface& b = boundary.faces[edge.faces[1]].surface;
  best = onto_both(a, b, best);
  for (int k = 0; k < kSlides; ++k) {
    const Vec3 t = cross(normal(a, best), normal(b, best));
    if (norm2(t) < 1e-12) break;  // tangent surfaces: the chord has to do
    const Vec3 slid = onto_both(a, b, best + (dot(p - best, t) / norm2(t)) * t);
    const double moved2 = norm2(slid - best);
    best = slid;
    if (moved2 <= 1e-28 * norm2(edge.points.back() - edge.points.front()) || moved2 == 0) break;
  }
  return best;
}

bool contains(const std::vector<int>& sorted, int value) {
  return std::ranges::binary_search(sorted, value);
}

bool vertex_on_face(const BoundaryModel& boundary, int vertex, int face) {
  const BoundaryVertex& v = boundary.vertices[vertex];
  const BoundaryFace& f = boundary.faces[face];
  if (v.edges.empty())  // the apex of a cone has a face and no edge
    return std::ranges::any_of(f.points, [&](const Vec3& p) {
      return distance(p, v.position) <= 1e-9 * boundary.bounds.diagonal();
    });
  return std::ranges::any_of(v.edges, [&](int e) { return contains(f.edges, e); });
}

}  // namespace

Vec3 project(const BoundaryModel& boundary, const BoundaryEdge& edge, const Vec3& p) {
  switch (edge.curve.kind) {
    case Curve::Kind::Line:
      return nearest_on_segment(edge.points.front(), edge.points.back(), p);
    case Curve::Kind::Circle:
      return nearest_on_circle(edge, p);
    case Curve::Kind::Other:
      break;
  }
  return nearest_on_polyline(boundary, edge, p);
}

Vec3 project(const BoundaryModel& boundary, const Support& support, const Vec3& p) {
  switch (support.kind) {
    case Support::Kind::Interior:
      break;
    case Support::Kind::Face:
      return project(boundary.faces[support.entity].surface, p);
    case Support::Kind::Edge:
      return project(boundary, boundary.edges[support.entity], p);
    case Support::Kind::Vertex:
      return boundary.vertices[support.entity].position;
  }
  return p;
}

bool incident(const BoundaryModel& boundary, const Support& a, const Support& b) {
  if (a.kind > b.kind) return incident(boundary, b, a);
  if (a.kind == b.kind) return a == b;
  if (a.kind == Support::Kind::Interior) return false;
  if (a.kind == Support::Kind::Edge) return contains(boundary.vertices[b.entity].edges, a.entity);
  if (b.kind == Support::Kind::Edge) return contains(boundary.faces[a.entity].edges, b.entity);
  return vertex_on_face(boundary, b.entity, a.entity);
}

}  // namespace remeshd
