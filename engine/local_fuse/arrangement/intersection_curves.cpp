#include "engine/local_fuse/arrangement/intersection_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/cellular/changes.h"

namespace remeshd {
namespace {

/// Sines of angles below which it is in doubt what meets, and counts beyond which a fuse by the CAD
/// kernel takes no longer.
struct CrossingLimits {
  double parallel = 1e-11;     ///< no angle at all
  double shallow = 1e-3;       ///< between planes, or a line and a plane
  double wall_to_plane = 0.1;  ///< between a plane and a round wall's axis
  double near_tangent = 0.01;  ///< gap to a tangent plane, x the curve's half extent normal to it
  std::size_t patches = 250;   ///< all pairs of them are looked at
  std::size_t curves = 1000;
};
constexpr CrossingLimits kCrossingLimits;

/// The least distance between two segments.
double distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double det = uu * vv - uv * uv;
  double s = det > 0 ? std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0) : 0;
  const double t = std::clamp((uv * s + vw) / vv, 0.0, 1.0);
  s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
  return norm(w + s * u - t * v);
}

class CurveFinder {
 public:
  CurveFinder(const Patches& patches, const Clearance& clearance)
      : patches_(patches.patches),
        edges_(patches.edges),
        same_(clearance.same),
        clear_(clearance.clear) {}

  Tried<std::vector<IntersectionCurve>> find() {
    if (patches_.size() > kCrossingLimits.patches)
      return GaveUp{"intersection_curves", "the features have too many faces"};
    for (const Patch& patch : patches_) boxes_.push_back(grown(patch.box, clear_));
    for (const PatchEdge& edge : edges_) add_edge(edge);
    for (int i = 0; i < static_cast<int>(patches_.size()); ++i)
      for (int j = i + 1; j < static_cast<int>(patches_.size()); ++j) {
        if (patches_[i].feature != patches_[j].feature && touch(boxes_[i], boxes_[j]))
          cross_patches(i, j);
        if (doubt_) return *doubt_;
        if (out_.size() > kCrossingLimits.curves)
          return GaveUp{"intersection_curves", "there are too many curves"};
      }
    for (IntersectionCurve& curve : out_)
      for (std::size_t p = 0; p < patches_.size(); ++p)
        curve.round ? split_round(curve, p) : split_line(curve, p);
    if (doubt_) return *doubt_;
    return std::move(out_);
  }

 private:
  void doubt(const char* why) {
    if (!doubt_) doubt_ = GaveUp{"intersection_curves", why};
  }

  void add_edge(const PatchEdge& edge) {
    if (edge.wall >= 0) {
      const Patch& wall = patches_[edge.wall];
      const Vec3 centre = rigid_inverse(wall.into).apply({0, 0, wall.into.apply(edge.from).z});
      IntersectionCurve& curve = add_round(wall, centre, wall.axis());
      for (const Vec3& end : {edge.from, edge.to})
        curve.splits.push_back({curve.parameter(end), wall.closed()});
      return;
    }
    IntersectionCurve& curve =
        add_line(edge.from, edge.to, normalised(edge.to - edge.from), {edge.feature});
    for (const Vec3& end : {edge.from, edge.to})
      curve.splits.push_back({curve.parameter(end), false});
    if (edge.seam >= 0) curve.seams.push_back(&patches_[edge.seam]);
  }
  static void add_features(IntersectionCurve& curve, const std::vector<int>& features) {
    for (const int f : features)
      if (std::ranges::find(curve.features, f) == curve.features.end()) curve.features.push_back(f);
  }

  IntersectionCurve& add_line(const Vec3& from, const Vec3& to, const Vec3& direction,
                              const std::vector<int>& features) {
    const auto off = [](const IntersectionCurve& c, const Vec3& p) {
      return norm(cross(p - c.origin, c.direction));
    };
    auto it = std::ranges::find_if(out_, [&](const IntersectionCurve& c) {
      return !c.round && off(c, from) <= same_ && off(c, to) <= same_ &&
             norm(cross(c.direction, direction)) < kCrossingLimits.shallow;
    });
    if (it == out_.end()) {
      IntersectionCurve curve;
      curve.origin = from;
      curve.direction = direction;
      out_.push_back(std::move(curve));
      it = out_.end() - 1;
    }
    for (const Vec3& end : {from, to}) {
      it->low = std::min(it->low, it->parameter(end));
      it->high = std::max(it->high, it->parameter(end));
    }
    add_features(*it, features);
    return *it;
  }

  /// The curve in which a plane cuts a wall's cylinder; `plane`: its normal, `centre`: where it
  /// meets the axis.
  IntersectionCurve& add_round(const Patch& wall, const Vec3& centre, const Vec3& plane) {
    const Vec3 axis = wall.axis();
    auto it = std::ranges::find_if(out_, [&](const IntersectionCurve& c) {
      return c.round && distance(c.origin, centre) <= same_ &&
             std::fabs(c.radius - wall.radius) <= same_ &&
             norm(cross(c.axis, axis)) < kCrossingLimits.parallel &&
             norm(cross(normalised(cross(c.u, c.v)), plane)) < kCrossingLimits.parallel;
    });
    if (it == out_.end()) {
      IntersectionCurve c;
      c.round = true;
      c.circle = norm(cross(axis, plane)) < kCrossingLimits.parallel;
      c.origin = centre;
      c.x = {wall.into.m[0], wall.into.m[1], wall.into.m[2]};
      c.y = {wall.into.m[4], wall.into.m[5], wall.into.m[6]};
      c.axis = axis;
      c.radius = wall.radius;
      const auto raised = [&](const Vec3& d) {
        return c.circle ? wall.radius * d
                        : wall.radius * (d - (dot(plane, d) / dot(plane, axis)) * axis);
      };
      c.u = raised(c.x);
      c.v = raised(c.y);
      out_.push_back(std::move(c));
      it = out_.end() - 1;
    }
    add_features(*it, {wall.feature});
    if (wall.closed()) {
      add_end(*it, wall, 0, true);
    } else {
      add_end(*it, wall, wall.first, false);
      add_end(*it, wall, wall.first + wall.angle, false);
    }
    return *it;
  }
  /// Splits the curve where it meets the wall's upright border, or seam, at `angle` about the axis.
  void add_end(IntersectionCurve& curve, const Patch& wall, double angle, bool seam) const {
    const Vec3 d = rigid_inverse(wall.into).rotate({std::cos(angle), std::sin(angle), 0});
    const double t = curve.parameter(curve.origin + d);
    const double z = wall.into.apply(curve.at(t).p).z;
    if (z >= wall.low - clear_ && z <= wall.high + clear_) curve.splits.push_back({t, seam});
  }

  void cross_patches(int i, int j) {
    const Patch &a = patches_[i], &b = patches_[j];
    if (!a.round && !b.round) return cross_planes(i, j);
    if (a.round && b.round) return cross_walls(i, j);
    a.round ? cross_wall(j, i) : cross_wall(i, j);
  }

  /// Adds the part of a line that lies in the boxes of both patches.
  void add_clipped(const Vec3& p, const Vec3& direction, int i, int j) {
    const Box box = intersection(boxes_[i], boxes_[j]);
    double low = -HUGE_VAL, high = HUGE_VAL;
    for (const auto& [o, d, l, h] : {std::array{p.x, direction.x, box.lo.x, box.hi.x},
                                     std::array{p.y, direction.y, box.lo.y, box.hi.y},
                                     std::array{p.z, direction.z, box.lo.z, box.hi.z}}) {
      if (std::fabs(d) < kCrossingLimits.parallel) {
        if (o < l || o > h) return;
        continue;
      }
      low = std::max(low, std::min((l - o) / d, (h - o) / d));
      high = std::min(high, std::max((l - o) / d, (h - o) / d));
    }
    if (high - low > clear_)  // else only the margins of the boxes meet
      add_line(p + low * direction, p + high * direction, direction,
               {patches_[i].feature, patches_[j].feature});
  }

  void cross_planes(int i, int j) {
    const Patch &a = patches_[i], &b = patches_[j];
    const Vec3 c = cross(a.normal, b.normal);
    const double sine = norm(c);
    if (sine <= kCrossingLimits.parallel) {
      const double d = std::fabs(b.distance_to(a.origin));
      if (d > same_ && d < clear_)
        doubt("two parallel planes are neither clearly the same nor clearly apart");
      return;
    }
    if (sine < kCrossingLimits.shallow) return doubt("two planes meet at a very small angle");
    // A point of both planes near the middle of the box, where it has to be most exact.
    const Box box = intersection(boxes_[i], boxes_[j]);
    Vec3 p = 0.5 * (box.lo + box.hi);
    for (int round = 0; round < 2; ++round) {
      const double da = a.distance_to(p), db = b.distance_to(p), k = dot(a.normal, b.normal);
      p +=
          ((-da + k * db) / (sine * sine)) * a.normal + ((-db + k * da) / (sine * sine)) * b.normal;
    }
    add_clipped(p, c / sine, i, j);
  }

  void cross_wall(int plane, int round) {
    const Patch &flat = patches_[plane], &wall = patches_[round];
    const Transform frame = rigid_inverse(wall.into);
    const Vec3 axis = wall.axis(), centre = frame.apply({0, 0, 0.5 * (wall.low + wall.high)});
    const double cosine = dot(flat.normal, axis), r = wall.radius;
    if (std::fabs(cosine) <= kCrossingLimits.parallel) {
      const double d = flat.distance_to(centre);
      if (std::fabs(std::fabs(d) - r) < std::max(clear_, kernel::kClearChord * r)) {
        doubt("a plane touches or nearly touches a cylinder along its side");
      } else if (std::fabs(d) < r) {
        const Vec3 side = std::sqrt(r * r - d * d) * cross(axis, flat.normal);
        for (const double s : {-1.0, 1.0})
          add_clipped(centre - d * flat.normal + s * side, axis, plane, round);
      }
      return;
    }
    const double sine = norm(cross(flat.normal, axis));
    if (std::fabs(cosine) < kCrossingLimits.wall_to_plane)
      return doubt("a plane meets the axis of a cylinder at a small angle");
    if (sine > kCrossingLimits.parallel && sine < kCrossingLimits.shallow)
      return doubt("a plane is nearly but not clearly at right angles to the axis of a cylinder");
    const Vec3 at = centre - (flat.distance_to(centre) / cosine) * axis;
    const double z = wall.into.apply(at).z, reach = r * sine / std::fabs(cosine) + clear_;
    if (z < wall.low - reach || z > wall.high + reach) return;
    IntersectionCurve& curve = add_round(wall, at, flat.normal);
    add_features(curve, {flat.feature});
  }

  void cross_walls(int i, int j) {
    const Patch &a = patches_[i], &b = patches_[j];
    const Transform frame = rigid_inverse(a.into), other = rigid_inverse(b.into);
    const double gap = std::max(clear_, kernel::kClearChord * std::max(a.radius, b.radius));
    if (norm(cross(a.axis(), b.axis())) > kCrossingLimits.parallel) {
      const double d =
          distance_of_segments(frame.apply({0, 0, a.low}), frame.apply({0, 0, a.high}),
                               other.apply({0, 0, b.low}), other.apply({0, 0, b.high}));
      if (d < a.radius + b.radius + gap)
        doubt("two cylinders meet or nearly meet whose axes are not parallel");
      return;
    }
    const Vec3 c = a.into.apply(other.apply({0, 0, b.low}));
    const double d = std::hypot(c.x, c.y), sum = a.radius + b.radius,
                 difference = std::fabs(a.radius - b.radius);
    if (d <= same_ && difference <= same_) return;  // they are one
    if (d > sum + gap || d < difference - gap) return;
    if (d > sum - gap || d < difference + gap)
      return doubt("two parallel cylinders touch or nearly touch");
    const auto [along, aside] = common_points(a.radius, b.radius, d);
    for (const double s : {-aside, aside})
      add_clipped(frame.apply({(along * c.x - s * c.y) / d, (along * c.y + s * c.x) / d, c.z}),
                  a.axis(), i, j);
  }
  /// Where two circles cross, whose centres are d apart: how far from the first one's centre
  /// towards the other's, and how far to both sides of that line.
  static std::pair<double, double> common_points(double r, double other, double d) {
    const double along = (d * d + r * r - other * other) / (2 * d);
    return {along, std::sqrt(std::max(0.0, r * r - along * along))};
  }

  void add_split(IntersectionCurve& curve, double t, std::size_t p) {
    if (boxes_[p].contains(curve.at(t).p)) curve.splits.push_back({t, false});
  }
  /// For a curve that touches a patch's surface at t, or nearly: in doubt unless the curve comes
  /// from the patch's own feature; then it is split there where they touch exactly.
  void touch_at(IntersectionCurve& curve, double t, std::size_t p, bool exactly) {
    if (!boxes_[p].contains(curve.at(t).p)) return;
    const bool own = std::ranges::find(curve.features, patches_[p].feature) != curve.features.end();
    if (own && exactly)
      curve.splits.push_back({t, false});
    else if (!own)
      doubt("a curve touches or nearly touches a face of another feature");
  }

  void split_line(IntersectionCurve& line, std::size_t p) {
    const Patch& patch = patches_[p];
    if (!patch.round) {
      const double slope = dot(line.direction, patch.normal);
      if (std::fabs(slope) <= kCrossingLimits.parallel) return;
      const double t = -patch.distance_to(line.origin) / slope;
      if (t < line.low - clear_ || t > line.high + clear_) return;
      if (std::fabs(slope) < kCrossingLimits.shallow && boxes_[p].contains(line.at(t).p))
        doubt("a line meets a plane at a very small angle");
      return add_split(line, t, p);
    }
    const Vec3 q = patch.into.apply(line.origin), d = patch.into.rotate(line.direction);
    const double speed = std::hypot(d.x, d.y);
    if (speed <= kCrossingLimits.parallel) return;
    const double nearest = std::fabs(q.x * d.y - q.y * d.x) / speed;
    const double middle = -(q.x * d.x + q.y * d.y) / (speed * speed);
    const double gap = std::fabs(nearest - patch.radius);
    if (gap < std::max(clear_, kernel::kClearChord * patch.radius) && middle > line.low - clear_ &&
        middle < line.high + clear_) {
      touch_at(line, middle, p, gap <= same_);
      if (gap <= same_) return;
    }
    if (nearest >= patch.radius) return;
    const double half = std::sqrt(patch.radius * patch.radius - nearest * nearest) / speed;
    for (const double t : {middle - half, middle + half})
      if (t > line.low - clear_ && t < line.high + clear_) {
        if (speed < kCrossingLimits.shallow && boxes_[p].contains(line.at(t).p))
          doubt("a line meets a cylinder at a very small angle");
        add_split(line, t, p);
      }
  }

  void split_round(IntersectionCurve& curve, std::size_t p) {
    const Patch& patch = patches_[p];
    if (patch.round) return split_by_wall(curve, p);
    const double a = dot(patch.normal, curve.u), b = dot(patch.normal, curve.v);
    const double d = -patch.distance_to(curve.origin), reach = std::hypot(a, b);
    if (reach <= same_) return;
    const double middle = std::atan2(b, a) + (d < 0 ? std::numbers::pi : 0);
    const double gap = std::fabs(std::fabs(d) - reach);
    if (gap < kCrossingLimits.near_tangent * reach) {
      touch_at(curve, middle, p, gap <= same_);
      if (gap <= same_) return;
    }
    if (std::fabs(d) >= reach) return;
    const double half = std::acos(std::fabs(d) / reach);
    for (const double t : {middle - half, middle + half}) add_split(curve, t, p);
  }

  /// Splits a round curve where a wall with a parallel axis crosses the curve's cylinder. A wall
  /// with another axis is clear of that cylinder, or cross_walls has given up. A wall that only
  /// touches the cylinder is of the same feature, and touches it where the curve is split already.
  void split_by_wall(IntersectionCurve& curve, std::size_t p) {
    const Patch& wall = patches_[p];
    if (norm(cross(wall.axis(), curve.axis)) > kCrossingLimits.parallel) return;
    const Vec3 c = wall.into.apply(curve.origin);
    const double d = std::hypot(c.x, c.y),
                 gap = kernel::kClearChord * std::max(wall.radius, curve.radius);
    if (d > wall.radius + curve.radius - gap || d < std::fabs(wall.radius - curve.radius) + gap)
      return;
    const Vec3 towards = rigid_inverse(wall.into).rotate({-c.x / d, -c.y / d, 0});
    const Vec3 side = cross(curve.axis, towards);
    const auto [along, aside] = common_points(curve.radius, wall.radius, d);
    for (const double s : {-aside, aside})
      add_split(curve, curve.parameter(curve.origin + along * towards + s * side), p);
  }

  const std::vector<Patch>& patches_;
  const std::vector<PatchEdge>& edges_;
  double same_, clear_;
  std::vector<Box> boxes_;  ///< by patch, a little larger
  std::vector<IntersectionCurve> out_;
  std::optional<GaveUp> doubt_;  ///< the first
};

}  // namespace

kernel::CurvePoint IntersectionCurve::at(double t) const {
  if (!round) return {origin + t * direction, direction};
  const double c = std::cos(t), s = std::sin(t);
  return {origin + c * u + s * v, c * v - s * u};
}

double IntersectionCurve::parameter(const Vec3& p) const {
  const Vec3 d = p - origin;
  return round ? std::atan2(dot(d, y), dot(d, x)) : dot(d, direction);
}

Tried<std::vector<IntersectionCurve>> find_intersection_curves(const Patches& patches,
                                                               const Clearance& clearance) {
  return CurveFinder(patches, clearance).find();
}

}  // namespace remeshd
