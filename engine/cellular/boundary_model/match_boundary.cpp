#include "engine/cellular/boundary_model/match_boundary.h"

#include <algorithm>

namespace remeshd {

namespace {

constexpr std::int32_t kNone = -1;

/// Pairs each element of `from` with the nearest of `to` by `distance_of`; nullopt where one has
/// none within `reach`, or two have the same.
template <class From, class To, class Place, class Distance>
std::optional<std::vector<std::int32_t>> pair_up(const std::vector<From>& from,
                                                 const std::vector<To>& to, double reach,
                                                 const Place& place_of,
                                                 const Distance& distance_of) {
  if (from.size() != to.size()) return std::nullopt;
  std::vector<std::int32_t> partner(from.size(), kNone);
  std::vector<std::uint8_t> taken(to.size(), 0);
  for (std::size_t a = 0; a < from.size(); ++a) {
    double nearest = reach;
    const Vec3 at = place_of(a);
    for (std::size_t b = 0; b < to.size(); ++b) {
      const double d = distance_of(from[a], to[b], at);
      if (!(d <= nearest)) continue;
      nearest = d;
      partner[a] = static_cast<std::int32_t>(b);
    }
    if (partner[a] == kNone || taken[partner[a]]) return std::nullopt;
    taken[partner[a]] = 1;
  }
  return partner;
}

std::vector<int> mapped(const std::vector<int>& entities,
                        const std::vector<std::int32_t>& partner) {
  std::vector<int> out;
  out.reserve(entities.size());
  for (const int e : entities) out.push_back(partner[e]);
  std::sort(out.begin(), out.end());
  return out;
}

/// A point of an edge by which it is told from others between the same vertices.
const Vec3& middle(const BoundaryEdge& edge) { return edge.points[edge.points.size() / 2]; }

}  // namespace

Support BoundaryMatch::operator()(const Support& support) const {
  switch (support.kind) {
    case Support::Kind::Vertex:
      return {support.kind, vertices[support.entity]};
    case Support::Kind::Edge:
      return {support.kind, edges[support.entity]};
    case Support::Kind::Face:
      return {support.kind, faces[support.entity]};
    case Support::Kind::Interior:
      break;
  }
  return support;
}

std::optional<BoundaryMatch> match_boundaries(const BoundaryModel& from, const BoundaryModel& to,
                                              double reach, const ExpectedPlace& expected) {
  const auto place = [&](Support::Kind kind, std::size_t entity, const Vec3& p) {
    return expected ? expected({kind, static_cast<std::int32_t>(entity)}, p) : p;
  };
  BoundaryMatch match;
  auto vertices = pair_up(
      from.vertices, to.vertices, reach,
      [&](std::size_t v) { return place(Support::Kind::Vertex, v, from.vertices[v].position); },
      [](const BoundaryVertex&, const BoundaryVertex& b, const Vec3& at) {
        return distance(at, b.position);
      });
  if (!vertices) return std::nullopt;
  match.vertices = std::move(*vertices);
  const auto vertex = [&](int v) { return v < 0 ? kNone : match.vertices[v]; };

  auto edges = pair_up(
      from.edges, to.edges, reach,
      [&](std::size_t e) { return place(Support::Kind::Edge, e, middle(from.edges[e])); },
      [&](const BoundaryEdge& a, const BoundaryEdge& b, const Vec3& at) {
        const std::pair ends{vertex(a.start), vertex(a.end)};
        if (a.curve.kind != b.curve.kind ||
            (ends != std::pair{b.start, b.end} && ends != std::pair{b.end, b.start}))
          return HUGE_VAL;
        return distance(at, project(to, b, at));
      });
  if (!edges) return std::nullopt;
  match.edges = std::move(*edges);

  auto faces = pair_up(
      from.faces, to.faces, reach,
      [&](std::size_t f) {
        const BoundaryFace& face = from.faces[f];
        return face.points.empty() ? Vec3{} : place(Support::Kind::Face, f, face.points.front());
      },
      [&](const BoundaryFace& a, const BoundaryFace& b, const Vec3& at) {
        if (a.names != b.names || a.surface.kind != b.surface.kind || a.reversed != b.reversed ||
            mapped(a.edges, match.edges) != b.edges)
          return HUGE_VAL;
        return a.points.empty() ? 0.0 : std::fabs(signed_distance(b.surface, at));
      });
  if (!faces) return std::nullopt;
  match.faces = std::move(*faces);
  for (std::size_t e = 0; e < from.edges.size(); ++e)
    if (mapped(from.edges[e].faces, match.faces) != to.edges[match.edges[e]].faces)
      return std::nullopt;
  return match;
}

}  // namespace remeshd
