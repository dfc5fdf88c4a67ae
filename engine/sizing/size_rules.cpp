#include "engine/sizing/size_rules.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/angle.h"
#include "engine/sizing/thin_places.h"

namespace remeshd {

namespace {

constexpr double kLeastShare = 0.1;  // of the base size, where no least size is given
/// So many more edges are asked for on circles: they come out unevenly long.
constexpr double kReserve = 1.2;
/// x least size: walls and gaps thinner and model edges shorter than that get no edges for it,
/// which would do no good.
constexpr double kFilm = 0.25;
constexpr double kOnFace = 0.92;    // nodes to a square of an edge length
constexpr double kInVolume = 1.41;  // to a cube of it

constexpr double kRounding = 1e-9;  // of a number of edges

/// A circle as the torus round it that has no tube.
Surface circle(const Curve& curve) {
  const Vec3 x = any_perpendicular(curve.direction);
  return {Surface::Kind::Torus,
          Transform::frame(x, cross(curve.direction, x), curve.direction, curve.origin),
          curve.radius, 0};
}

}  // namespace

double least_size(const Sizing& sizing, double base) {
  return std::fmin(base, sizing.min_size.value_or(kLeastShare * base));
}

std::vector<SizeRules::Detail> SizeRules::circles_of(const BoundaryModel& boundary,
                                                     double per_radius, double slope) {
  std::vector<Detail> circles;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const BoundaryFace& face = boundary.faces[f];
    const Surface& surface = face.surface;
    if (surface.kind == Surface::Kind::Plane) continue;
    // Of a steep cone edges may not grow as fast as its circles do.
    const double size = surface.kind == Surface::Kind::Cone
                            ? std::fmin(per_radius, slope / std::fabs(surface.r2))
                            : per_radius * radius_of_curvature(surface, face.points.front());
    circles.push_back({static_cast<int>(f), {surface, box_of(face.points), size}});
  }
  for (const BoundaryEdge& edge : boundary.edges)
    if (edge.curve.kind == Curve::Kind::Circle)
      circles.push_back(
          {edge.faces.front(),
           {circle(edge.curve), box_of(edge.points), per_radius * edge.curve.radius}});
  return circles;
}

std::vector<SizeRules::Detail> SizeRules::short_edges_of(const BoundaryModel& boundary, double film,
                                                         double most) {
  std::vector<Detail> edges;
  for (const BoundaryEdge& edge : boundary.edges) {
    if (edge.closed() || edge.length < film || edge.length >= most) continue;
    // Its middle as well, for it may be an arc.
    const std::array<Vec3, 3> piece{edge.points.front(), edge.points[edge.points.size() / 2],
                                    edge.points.back()};
    edges.push_back({edge.faces.front(), {piece, box_of(piece), edge.length}});
  }
  return edges;
}

SizeRules::SizeRules(const BoundaryModel& boundary, const Sizing& sizing, const BaseSizes& bases,
                     const Run& run, std::vector<SizeSource> asked)
    : sizing_(sizing), bounds_(boundary.bounds) {
  if (sizing.even) return;
  asked_ = std::move(asked);
  if (sizing.edges_per_circle > 0)
    details_ = circles_of(boundary, kTurn / (kReserve * sizing.edges_per_circle), slope());
  if (sizing.layers == 0) return;
  const double most = bases.greatest;
  const double least = least_size(sizing, bases.expected), film = kFilm * least;
  const auto edges = short_edges_of(boundary, film, most);
  details_.insert(details_.end(), edges.begin(), edges.end());
  thin_places_ = thin_places(boundary,
                             {.most = sizing.layers * most,
                              .least = sizing.layers * least,
                              .film = sizing.layers * film,
                              .slope = sizing.layers * slope()},
                             run);
}

SizeField SizeRules::field(double base, double weakening) const {
  std::vector<SizeSource> sources;
  sources.reserve(details_.size() + thin_places_.size() + asked_.size());
  for (const Detail& detail : details_) sources.push_back(detail.source);
  for (const ThinPlace& place : thin_places_)
    if (size_of(place) >= kFilm * least_size(sizing_, base))
      sources.push_back({place.triangle, box_of(place.triangle), size_of(place)});
  for (SizeSource& source : sources) source.size *= weakening;
  sources.insert(sources.end(), asked_.begin(), asked_.end());
  return SizeField({base, least_size(sizing_, base), slope()}, std::move(sources), bounds_);
}

std::vector<SizeRules::AskedOnFace> SizeRules::asked_on_faces(double weakening) const {
  std::vector<AskedOnFace> asked;
  for (const Detail& detail : details_)
    if (!detail.source.varies()) asked.push_back({detail.face, weakening * detail.source.size});
  for (const ThinPlace& place : thin_places_)
    asked.push_back({place.face, weakening * size_of(place)});
  return asked;
}

std::vector<int> SizeRules::unresolved(double base, double weakening) const {
  const double least = least_size(sizing_, base);
  std::vector<int> faces;
  for (const auto& [face, size] : asked_on_faces(weakening))
    if (size < least) faces.push_back(face);
  std::ranges::sort(faces);
  const auto twice = std::ranges::unique(faces);
  faces.erase(twice.begin(), twice.end());
  return faces;
}

std::vector<int> SizeRules::fewest_links(const BoundaryModel& boundary, double base,
                                         double weakening) const {
  std::vector<int> fewest(boundary.edges.size(), 0);
  const double least = least_size(sizing_, base);
  for (std::size_t e = 0; e < fewest.size(); ++e) {
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.curve.kind != Curve::Kind::Circle) continue;
    const double circle = kTurn * edge.curve.radius;
    const double links = std::fmin(sizing_.edges_per_circle / weakening, circle / least);
    fewest[e] = static_cast<int>(links * edge.length / circle + kRounding);
  }
  return fewest;
}

double ThinSide::nodes(double length) const {
  const double more = kOnFace - 0.5 * kInVolume * thickness / length;
  return std::fmax(more, 0) * area / (length * length);
}

std::vector<ThinSide> SizeRules::sides() const {
  std::vector<ThinSide> sides;
  sides.reserve(thin_places_.size());
  for (const ThinPlace& place : thin_places_) {
    const auto& [a, b, c] = place.triangle;
    sides.push_back({.middle = (1.0 / 3) * (a + b + c),
                     .area = 0.5 * norm(cross(b - a, c - a)),
                     .thickness = place.thickness});
  }
  return sides;
}

}  // namespace remeshd
