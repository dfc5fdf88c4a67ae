#include "engine/boundary/entity_map.h"

#include <algorithm>
#include <cmath>

#include "engine/cellular/boundary_model/face_distance.h"

namespace remeshd {

namespace {

template <class Entity>
std::vector<Box> boxes_of(const std::vector<Entity>& entities, double margin) {
  std::vector<Box> boxes;
  boxes.reserve(entities.size());
  for (const Entity& e : entities) boxes.push_back(grown(box_of(e.points), margin));
  return boxes;
}

bool same_curve(const BoundaryEdge& a, const BoundaryEdge& b, double tolerance) {
  if (a.curve.kind != b.curve.kind) return false;
  switch (a.curve.kind) {
    case Curve::Kind::Line:
      return std::ranges::all_of(std::array{a.points.front(), a.points.back()}, [&](const Vec3& p) {
        const Vec3 d = p - b.curve.origin;
        return norm(d - dot(d, b.curve.direction) * b.curve.direction) <= tolerance;
      });
    case Curve::Kind::Circle:
      return distance(a.curve.origin, b.curve.origin) <= tolerance &&
             std::fabs(a.curve.radius - b.curve.radius) <= tolerance &&
             norm(cross(a.curve.direction, b.curve.direction)) * a.curve.radius <= tolerance;
    case Curve::Kind::Other:
      return true;
  }
  return false;
}

}  // namespace

EntityMap::EntityMap(const BoundaryModel& from, const BoundaryModel& to, double tolerance)
    : to_(to) {
  const auto pair_up = [&](Support::Kind kind, std::size_t here, std::size_t there,
                           const auto& same) {
    auto& candidates = candidates_[static_cast<int>(kind)];
    candidates.resize(here);
    for (std::size_t a = 0; a < here; ++a)
      for (std::size_t b = 0; b < there; ++b)
        if (same(a, b)) candidates[a].push_back(static_cast<int>(b));
  };
  pair_up(Support::Kind::Vertex, from.vertices.size(), to.vertices.size(), [&](auto a, auto b) {
    return distance(from.vertices[a].position, to.vertices[b].position) <= tolerance;
  });
  const std::vector<Box> edge_from = boxes_of(from.edges, tolerance);
  const std::vector<Box> edge_to = boxes_of(to.edges, tolerance);
  pair_up(Support::Kind::Edge, from.edges.size(), to.edges.size(), [&](auto a, auto b) {
    return touch(edge_from[a], edge_to[b]) && same_curve(from.edges[a], to.edges[b], tolerance);
  });
  const std::vector<Box> face_from = boxes_of(from.faces, tolerance);
  const std::vector<Box> face_to = boxes_of(to.faces, tolerance);
  pair_up(Support::Kind::Face, from.faces.size(), to.faces.size(), [&](auto a, auto b) {
    const BoundaryFace &f = from.faces[a], &g = to.faces[b];
    if (f.surface.kind != g.surface.kind || !touch(face_from[a], face_to[b])) return false;
    const Vec3& p = f.points.front();
    return dot(outward_normal(f, p), outward_normal(g, p)) > 0 &&
           same_surface(f.surface, g.surface, face_from[a], tolerance);
  });
}

double EntityMap::distance2(Support::Kind kind, int entity, const Vec3& p) const {
  return kind == Support::Kind::Face ? face_distance2(to_.faces[entity], p)
                                     : norm2(p - project(to_, to_.edges[entity], p));
}

std::optional<Support> EntityMap::operator()(const Support& support, const Vec3& p) const {
  if (support.kind == Support::Kind::Interior) return support;
  const std::vector<int>& candidates = candidates_[static_cast<int>(support.kind)][support.entity];
  if (candidates.empty()) return std::nullopt;
  if (candidates.size() == 1) return Support{support.kind, candidates.front()};
  int nearest = candidates.front();
  if (support.kind != Support::Kind::Vertex) {
    double least = HUGE_VAL;
    for (const int entity : candidates) {
      const double d = distance2(support.kind, entity, p);
      if (d < least) {
        least = d;
        nearest = entity;
      }
    }
  }
  return Support{support.kind, nearest};
}

}  // namespace remeshd
