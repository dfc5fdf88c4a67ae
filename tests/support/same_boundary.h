#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/cellular/cellular_model.h"

namespace remeshd::test {

/// What makes two cellular models differ by more than rounding, first of all: entities, their
/// order, who bounds whom, names, surfaces to the bit, positions, lengths, areas, volume. Empty
/// where they are the same.
inline std::string difference_of(const CellularModel& a, const CellularModel& b) {
  const BoundaryModel &x = a.boundary, &y = b.boundary;
  const double length = x.bounds.diagonal();
  const auto far = [&](const Vec3& p, const Vec3& q) { return distance(p, q) > 1e-8 * length; };
  const auto name = [](const char* what, std::size_t i) {
    return std::string(what) + ' ' + std::to_string(i);
  };
  if (x.vertices.size() != y.vertices.size() || x.edges.size() != y.edges.size() ||
      x.faces.size() != y.faces.size())
    return "counts " + name("", x.vertices.size()) + name("/", y.vertices.size()) +
           name(" ", x.edges.size()) + name("/", y.edges.size()) + name(" ", x.faces.size()) +
           name("/", y.faces.size());
  for (std::size_t i = 0; i < x.vertices.size(); ++i) {
    if (far(x.vertices[i].position, y.vertices[i].position)) return name("vertex", i);
    if (x.vertices[i].edges != y.vertices[i].edges) return name("edges of vertex", i);
  }
  for (std::size_t i = 0; i < x.edges.size(); ++i) {
    const BoundaryEdge &p = x.edges[i], &q = y.edges[i];
    if (p.start != q.start || p.end != q.end || p.faces != q.faces) return name("edge", i);
    if (p.curve.kind != q.curve.kind) return name("curve of edge", i);
    if (std::fabs(p.length - q.length) > 1e-7 * length) return name("length of edge", i);
    if (p.points.size() != q.points.size()) return name("number of points of edge", i);
    for (std::size_t k = 0; k < p.points.size(); ++k)
      if (distance(p.points[k], q.points[k]) > 1e-6 * length) return name("points of edge", i);
  }
  for (std::size_t i = 0; i < x.faces.size(); ++i) {
    const BoundaryFace &p = x.faces[i], &q = y.faces[i];
    if (p.edges != q.edges) return name("edges of face", i);
    if (p.names != q.names) return name("names of face", i);
    if (p.reversed != q.reversed) return name("side of face", i);
    if (p.surface.kind != q.surface.kind || p.surface.frame != q.surface.frame ||
        p.surface.r1 != q.surface.r1 || p.surface.r2 != q.surface.r2)
      return name("surface of face", i);
    if (std::fabs(p.area - q.area) > 1e-6 * std::max(p.area, 1e-3 * length * length))
      return name("area of face", i);
  }
  if (std::fabs(a.area - b.area) > 1e-7 * a.area) return "area";
  if (std::fabs(a.volume - b.volume) > 1e-7 * a.volume) return "volume";
  return "";
}

}  // namespace remeshd::test
