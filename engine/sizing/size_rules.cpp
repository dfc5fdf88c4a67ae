#include "engine/sizing/size_rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/base/angle.h"
#include "engine/sizing/narrow_faces.h"
#include "engine/sizing/reserve.h"
#include "engine/sizing/thin_places.h"

namespace remeshd {

namespace {

constexpr double kLeastShare = 0.1;  // of the base size, where no least size is given
/// x least size: walls and gaps thinner than this are films. No edges are asked for across a film,
/// since they would not make its tets better.
constexpr double kFilm = 0.25;
/// x least size: the same limit for model edges and narrow faces. It is lower, since short edges at
/// a low step do make the tets there less flat.
constexpr double kLowStep = 0.1;
constexpr double kOnFace = 0.82;    // nodes per square of the edge length
constexpr double kInVolume = 1.41;  // nodes per cube of the edge length

constexpr double kRounding = 1e-9;  // of a number of edges
constexpr double kMostAcross = 3;   // x layers: edges asked for across a wall

struct CircleSteps {
  double share = 0.5;    ///< x the length asked for: step between circles of a torus
  double widest = 0.35;  ///< rad: no step is wider
  double most = 1e4;     ///< circles on a face, about
};
constexpr CircleSteps kCircles;

/// Of the faces of an edge one that is not plane, where there is one: a hole's rather than that of
/// the plate it is in.
int rounder_face_of(const BoundaryEdge& edge, const BoundaryModel& boundary) {
  const auto is_round = [&](int f) {
    return boundary.faces[f].surface.kind != Surface::Kind::Plane;
  };
  const auto found = std::ranges::find_if(edge.faces, is_round);
  return found != edge.faces.end() ? *found : edge.faces.front();
}

/// A circle as a torus with minor radius 0.
Surface circle(const Vec3& centre, const Vec3& axis, double radius) {
  const Vec3 x = any_perpendicular(axis);
  return {Surface::Kind::Torus, Transform::frame(x, cross(axis, x), axis, centre), radius, 0};
}

Vec3 axis_of(const Surface& surface) { return surface.frame.rotate({0, 0, 1}); }

/// The point of a surface's axis that is nearest to p.
Vec3 foot_on_axis(const Surface& surface, const Vec3& p) {
  const Vec3 origin = surface.frame.apply({}), axis = axis_of(surface);
  return origin + dot(axis, p - origin) * axis;
}

/// The circle round a surface's axis that p is on.
Surface circle_through(const Surface& surface, const Vec3& p) {
  const Vec3 centre = foot_on_axis(surface, p);
  return circle(centre, axis_of(surface), distance(p, centre));
}

/// The point of a face that is nearest to the axis of its surface.
Vec3 nearest_to_axis(const BoundaryFace& face) {
  return *std::ranges::min_element(
      face.points, {}, [&](const Vec3& p) { return distance(p, foot_on_axis(face.surface, p)); });
}

/// The circles round the axis of a torus along which it bends more than round its tube: on the
/// inner side of a ring, round a barrel.
class TightCircles {
 public:
  explicit TightCircles(const Surface& torus)
      : torus_(torus),
        centre_(torus.frame.apply({})),
        axis_(axis_of(torus)),
        side_(torus.r1 > 0 ? -1.0 : 1.0) {}

  /// The angle round the tube at which a point is, rad; 0 on the inner equator, of a lemon (r1 < 0)
  /// on its only one.
  [[nodiscard]] double angle_of(const Vec3& p) const {
    const double z = dot(axis_, p - centre_);
    return std::atan2(z, side_ * (norm(p - centre_ - z * axis_) - torus_.r1));
  }
  [[nodiscard]] double radius(double angle) const {
    return std::fmax(0, torus_.r1 + side_ * torus_.r2 * std::cos(angle));
  }
  [[nodiscard]] double radius_of_curvature(double angle) const {
    return radius(angle) / std::cos(angle);
  }
  [[nodiscard]] Surface at(double angle) const {
    return circle(centre_of(angle), axis_, radius(angle));
  }
  [[nodiscard]] Box box(double angle) const {
    const auto reach = [&](double along) {
      return radius(angle) * std::sqrt(std::fmax(0, 1 - along * along));
    };
    const Vec3 reaches{reach(axis_.x), reach(axis_.y), reach(axis_.z)};
    return {centre_of(angle) - reaches, centre_of(angle) + reaches};
  }

 private:
  [[nodiscard]] Vec3 centre_of(double angle) const {
    return centre_ + torus_.r2 * std::sin(angle) * axis_;
  }

  const Surface& torus_;
  Vec3 centre_, axis_;
  double side_;  ///< -1: angle 0 is on the side of the tube's centre that faces the axis
};

}  // namespace

double least_size(const Sizing& sizing, double base) {
  return std::fmin(base, sizing.min_size.value_or(kLeastShare * base));
}

double edges_asked_across(const Sizing& sizing) {
  const double layers = sizing.layers;
  if (layers <= 1) return layers;
  // From each side the length grows by the slope: 2 ln(1 + asked slope / 2) / slope edges fit.
  const double slope = sizing.growth - 1;
  const double asked = 2 / slope * std::expm1(0.5 * slope * kReserveInside * layers);
  return std::fmin(asked, kMostAcross * layers);
}

std::vector<SizeRules::Detail> SizeRules::round_details_of(const BoundaryModel& boundary,
                                                           double per_radius, double slope,
                                                           double least) {
  using Kind = Surface::Kind;
  std::vector<Detail> details;
  for (int f = 0; f < std::ssize(boundary.faces); ++f) {
    const BoundaryFace& face = boundary.faces[f];
    const Surface& surface = face.surface;
    const Box box = box_of(face.points);
    const Vec3& at = face.points.front();
    switch (surface.kind) {
      case Kind::Plane:
        break;
      case Kind::Cone:
        // Where circles grow faster than the slope allows, only the smallest counts.
        if (per_radius * std::fabs(surface.r2) > slope) {
          const Vec3 p = nearest_to_axis(face);
          const double size = per_radius * radius_of_curvature(surface, p);
          details.push_back({f, p, {circle_through(surface, p), box, size}, true});
        } else {
          details.push_back({f, at, {surface, box, per_radius}, true});
        }
        break;
      case Kind::Cylinder:
      case Kind::Sphere:
        details.push_back({f, at, {surface, box, per_radius * surface.r1}});
        break;
      case Kind::Torus:
        details.push_back({f, at, {surface, box, per_radius * surface.r2}});
        add_circles_of(face, f, per_radius, least, details);
    }
  }
  for (const BoundaryEdge& edge : boundary.edges)
    if (const Curve& c = edge.curve; c.kind == Curve::Kind::Circle)
      details.push_back(
          {rounder_face_of(edge, boundary),
           edge.points.front(),
           {circle(c.origin, c.direction, c.radius), box_of(edge.points), per_radius * c.radius}});
  return details;
}

void SizeRules::add_circles_of(const BoundaryFace& face, int index, double per_radius, double least,
                               std::vector<Detail>& details) {
  const Surface& torus = face.surface;
  const TightCircles circles(torus);
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  const auto is_tight = [&](double angle) {
    return std::fabs(angle) < 0.25 * kTurn && circles.radius_of_curvature(angle) < torus.r2;
  };
  for (const Vec3& p : face.points)
    if (const double angle = circles.angle_of(p); is_tight(angle)) {
      lowest = std::fmin(lowest, angle);
      highest = std::fmax(highest, angle);
    }
  const Box of_face = box_of(face.points);
  const bool tapers = std::fabs(torus.r1) < torus.r2;
  for (double angle = lowest; angle <= highest;) {
    const double size = per_radius * circles.radius_of_curvature(angle);
    const Box box = intersection(circles.box(angle), of_face);
    // An apple, the outer part of a spindle torus, has nothing between its tips.
    if (circles.radius(angle) > 0 && is_tight(angle) && !box.empty())
      details.push_back({index, face.points.front(), {circles.at(angle), box, size}, tapers});
    const double step = kCircles.share * std::fmax(size, least) / torus.r2;
    angle += std::fmin(kCircles.widest, std::fmax(step, (highest - lowest) / kCircles.most));
  }
}

std::vector<SizeRules::Detail> SizeRules::short_edges_of(const BoundaryModel& boundary, double step,
                                                         double most) {
  std::vector<Detail> edges;
  for (const BoundaryEdge& edge : boundary.edges) {
    if (edge.closed() || edge.length < step || edge.length >= most) continue;
    // The middle of the edge as well, for it may be an arc.
    const std::array<Vec3, 3> piece{edge.points.front(), edge.points[edge.points.size() / 2],
                                    edge.points.back()};
    edges.push_back(
        {rounder_face_of(edge, boundary), piece[1], {piece, box_of(piece), edge.length}});
  }
  return edges;
}

void SizeRules::add_narrow_faces(const BoundaryModel& boundary, double most, double least,
                                 const Run& run) {
  const NarrowFaceLimits limits{
      .most = across_ * most, .least = across_ * least, .film = across_ * kLowStep * least};
  for (const NarrowPlace& place : narrow_faces(boundary, limits, run)) {
    const auto& [a, b] = place.piece;
    const std::array<Vec3, 3> piece{a, 0.5 * (a + b), b};
    details_.push_back({place.face, piece[1], {piece, box_of(piece), place.width / across_}});
  }
}

SizeRules::SizeRules(const BoundaryModel& boundary, const Sizing& sizing, const BaseSizes& bases,
                     const Run& run, std::vector<SizeSource> asked)
    : sizing_(sizing), across_(edges_asked_across(sizing)), bounds_(boundary.bounds) {
  if (sizing.even) return;
  asked_ = std::move(asked);
  const double most = bases.greatest;
  const double least = least_size(sizing, bases.expected);
  if (sizing.edges_per_circle > 0)
    details_ =
        round_details_of(boundary, kTurn / (kReserve * sizing.edges_per_circle), slope(), least);
  if (sizing.layers == 0) return;
  const auto edges = short_edges_of(boundary, kLowStep * least, most);
  details_.insert(details_.end(), edges.begin(), edges.end());
  add_narrow_faces(boundary, most, least, run);
  thin_places_ = thin_places(boundary,
                             {.most = across_ * most,
                              .least = across_ * least,
                              .film = across_ * kFilm * least,
                              .slope = across_ * slope()},
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
    if (!detail.tapers) asked.push_back({detail.face, weakening * detail.source.size, detail.at});
  for (const ThinPlace& place : thin_places_)
    asked.push_back({place.face, weakening * size_of(place), place.triangle.front()});
  return asked;
}

std::vector<SizeRules::AskedOnFace> SizeRules::unresolved(double base, double weakening) const {
  const double least = least_size(sizing_, base);
  std::map<int, AskedOnFace> by_face;
  const auto add = [&](const AskedOnFace& asked) {
    const auto [found, is_first] = by_face.try_emplace(asked.face, asked);
    if (!is_first && asked.size < found->second.size) found->second = asked;
  };
  for (const AskedOnFace& asked : asked_on_faces(weakening))
    if (asked.size < least) add(asked);
  for (const ThinPlace& place : thin_places_)
    if (place.thinner)
      add({place.face, std::fmin(least, weakening * size_of(place)), place.triangle.front()});
  std::vector<AskedOnFace> faces;
  for (const auto& [face, asked] : by_face) faces.push_back(asked);
  std::ranges::stable_sort(faces, {}, &AskedOnFace::size);
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
