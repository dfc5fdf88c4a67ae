#include "engine/cellular/boundary_model/edge_curve.h"

#include <algorithm>

#include "engine/kernel/curve_points.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

bool positive(const Vec3& axis) {
  for (const double c : {axis.x, axis.y, axis.z})
    if (std::fabs(c) > 1e-9) return c > 0;
  return true;
}

void reverse(BoundaryEdge& edge) {
  std::reverse(edge.points.begin(), edge.points.end());
  std::swap(edge.start, edge.end);
  edge.curve.direction = -edge.curve.direction;
}

void sample_circle(BoundaryEdge& edge) {
  const Curve& circle = edge.curve;
  const bool free = edge.start < 0;
  const Vec3 axis = circle.direction;
  Vec3 u = free ? any_perpendicular(axis) : edge.points.front() - circle.origin;
  u = normalised(u - dot(u, axis) * axis);
  const Vec3 v = cross(axis, u);
  const double angle = edge.length / circle.radius;
  const int n = kernel::steps_of(angle, kernel::kPointTurning);
  const Vec3 first = edge.points.front(), last = edge.points.back();
  edge.points.clear();
  for (int i = 0; i <= n; ++i) {
    const double t = angle * i / n;
    edge.points.push_back(circle.origin + circle.radius * (std::cos(t) * u + std::sin(t) * v));
  }
  if (!free) edge.points.front() = first;
  edge.points.back() = free ? edge.points.front() : last;
}

/// Nearby point on all surfaces, by projecting onto one after the other.
Vec3 onto_all(const std::vector<const Surface*>& surfaces, Vec3 p, double tolerance) {
  for (int i = 0; i < 200; ++i) {
    double worst = 0;
    for (const Surface* s : surfaces) {
      const double d = signed_distance(*s, p);
      worst = std::max(worst, std::fabs(d));
      if (std::fabs(d) > tolerance) p = project(*s, p);
    }
    if (worst <= tolerance) break;
  }
  return p;
}

}  // namespace

Vec3 onto_both(const Surface& a, const Surface& b, const Vec3& start) {
  Vec3 p = start;
  for (int i = 0; i < 20; ++i) {
    const Vec3 na = normal(a, p), nb = normal(b, p);
    const double da = signed_distance(a, p), db = signed_distance(b, p);
    const double c = dot(na, nb);
    const double det = 1 - c * c;
    if (det < 1e-12) return project(a, p);  // tangent: no direction leads to both
    const Vec3 step = ((-da + c * db) / det) * na + ((-db + c * da) / det) * nb;
    p += step;
    if (norm2(step) <= 1e-30 * (1 + norm2(p))) break;
  }
  return p;
}

void make_canonical(BoundaryEdge& edge) {
  const bool circle = edge.curve.kind == Curve::Kind::Circle;
  if (!edge.closed()) {
    if (edge.start > edge.end) reverse(edge);
  } else if (circle ? !positive(edge.curve.direction)
                    : lies_before(*(edge.points.end() - 2), edge.points[1])) {
    reverse(edge);
  }
  if (circle) sample_circle(edge);
  if (edge.curve.kind == Curve::Kind::Line) {
    edge.points = {edge.points.front(), edge.points.back()};
    edge.curve.origin = edge.points.front();
    edge.curve.direction = normalised(edge.points.back() - edge.points.front());
  }
}

void refine(BoundaryModel& model, double tolerance) {
  const double exact = 1e-6 * tolerance;
  for (BoundaryVertex& vertex : model.vertices) {
    std::vector<int> faces;
    for (const int e : vertex.edges)
      faces.insert(faces.end(), model.edges[e].faces.begin(), model.edges[e].faces.end());
    sort_unique(faces);
    std::vector<const Surface*> surfaces;
    for (const int f : faces) surfaces.push_back(&model.faces[f].surface);
    vertex.position = onto_all(surfaces, vertex.position, exact);
  }
  for (BoundaryEdge& edge : model.edges) {
    if (edge.start >= 0) edge.points.front() = model.vertices[edge.start].position;
    if (edge.end >= 0) edge.points.back() = model.vertices[edge.end].position;
    if (edge.curve.kind == Curve::Kind::Line) edge.curve.origin = edge.points.front();
    if (edge.curve.kind != Curve::Kind::Other || edge.faces.size() != 2) continue;
    const Surface& a = model.faces[edge.faces[0]].surface;
    const Surface& b = model.faces[edge.faces[1]].surface;
    const std::size_t n = edge.points.size();
    for (std::size_t i = edge.start < 0 ? 0 : 1; i + 1 < n; ++i)
      edge.points[i] = onto_both(a, b, edge.points[i]);
    if (edge.start < 0) edge.points.back() = edge.points.front();
  }
}

}  // namespace remeshd
