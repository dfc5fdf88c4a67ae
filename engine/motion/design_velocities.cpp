#include "engine/motion/design_velocities.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/base/tolerance.h"

namespace remeshd {
namespace {

using Ref = FeatureSurfaces::Ref;

struct TouchLimits {
  double sine = 1e-6;  ///< of the angle between surfaces that touch, at most
  double step = 1e-6;  ///< x the model's size: step of finite differences in space
  double same = 1e-4;  ///< difference of curvatures x the model's size: below it, one surface
};
constexpr TouchLimits kTouch;

struct FootLimits {
  double sine = 1e-3;   ///< of the angle between surfaces that cross, at least
  double rest = 1e-15;  ///< x the model's size: a step that is less is the last
  int steps = 100;
};
constexpr FootLimits kFoot;
const std::array<Vec3, 3> kAxes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

/// The point nearest to m on the curve where two surfaces cross, found from `near`, a point near to
/// it; nothing where they do not cross there.
std::optional<Vec3> foot(const Surface& a, const Surface& b, const Vec3& m, const Vec3& near,
                         double size) {
  Vec3 x = near;
  for (int step = 0; step < kFoot.steps; ++step) {
    const Vec3 n = normal(a, x), o = normal(b, x);
    const Vec3 along = cross(n, o);
    const double sine2 = norm2(along), cosine = dot(n, o);
    if (sine2 < kFoot.sine * kFoot.sine) return {};
    // Along the curve's tangent to the foot of m, and onto the tangent planes of both surfaces.
    const double off_a = signed_distance(a, x), off_b = signed_distance(b, x);
    const Vec3 by = (dot(along, m - x) / sine2) * along + ((cosine * off_b - off_a) / sine2) * n +
                    ((cosine * off_a - off_b) / sine2) * o;
    x += by;
    if (norm(by) <= kFoot.rest * size) return x;
  }
  return x;
}

/// The apex of a cone; nothing for other surfaces.
std::optional<Vec3> apex_of(const Surface& surface) {
  if (surface.kind != Surface::Kind::Cone || surface.r2 == 0) return {};
  return surface.frame.apply({0, 0, -surface.r1 / surface.r2});
}

}  // namespace

class ChangingFaces {
 public:
  /// `size`: of the model, length.
  ChangingFaces(const FacesOfModel& now, const ParameterChange& change, double size)
      : now_(now),
        less_(change.less),
        more_(change.more),
        between_(change.between),
        step_(kTouch.step * size) {}

  /// The motion of a surface at one of its points; nothing where it is not of the same kind at both
  /// ends of the change.
  [[nodiscard]] std::optional<SurfaceMotion> motion(const Ref& ref, const Vec3& p) const {
    const Surface *now = now_.find(ref), *before = less_.find(ref, now_),
                  *after = more_.find(ref, now_);
    if (before == nullptr || after == nullptr || before->kind != now->kind ||
        after->kind != now->kind)
      return {};
    return SurfaceMotion{normal(*now, p),
                         (signed_distance(*before, p) - signed_distance(*after, p)) / between_};
  }

  [[nodiscard]] std::optional<Vec3> apex_velocity(const Ref& ref) const {
    const Surface *before = less_.find(ref, now_), *after = more_.find(ref, now_);
    if (before == nullptr || after == nullptr) return {};
    const auto from = apex_of(*before), to = apex_of(*after);
    if (!from || !to) return {};
    return (*to - *from) / between_;
  }

  /// How the curve along which two surfaces touch moves across itself, in their common tangent
  /// plane; nothing where they cross, or are one.
  ///
  /// On the curve the normals are the same, beside it they are not: with g their difference, a
  /// point that stays on it has the velocity v across it for which g' v + dg/dp = 0.
  [[nodiscard]] std::optional<SurfaceMotion> tangency(const Ref& a, const Ref& b,
                                                      const Vec3& p) const {
    if (!motion(a, p) || !motion(b, p)) return {};
    const Vec3 n = normal(*now_.find(a), p);
    const Vec3 other = normal(*now_.find(b), p);
    if (norm(cross(n, other)) > kTouch.sine) return {};
    const double side = dot(n, other) < 0 ? -1 : 1;
    const auto gap = [&](const FacesOfModel& faces, const Vec3& at) {
      return normal(*faces.find(a, now_), at) - side * normal(*faces.find(b, now_), at);
    };
    const auto slope = [&](const Vec3& along) {
      return (gap(now_, p + step_ * along) - gap(now_, p - step_ * along)) / (2 * step_);
    };
    // The difference of the curvatures is a symmetric matrix: the direction of its larger
    // eigenvalue is across.
    const Vec3 x = any_perpendicular(n), y = cross(n, x);
    const Vec3 by_x = slope(x), by_y = slope(y);
    const double xx = dot(by_x, x), yy = dot(by_y, y), xy = 0.5 * (dot(by_x, y) + dot(by_y, x));
    const double mean = 0.5 * (xx + yy);
    const double curvature = mean + std::copysign(std::hypot(0.5 * (xx - yy), xy), mean);
    if (std::fabs(curvature) * step_ < kTouch.same * kTouch.step) return {};
    const Vec3 one = xy * x + (curvature - xx) * y, another = (curvature - yy) * x + xy * y;
    const Vec3 across = normalised(norm2(one) > norm2(another) ? one : another);
    const Vec3 change = (gap(more_, p) - gap(less_, p)) / between_;
    return SurfaceMotion{across, -dot(across, change) / curvature};
  }

  /// The motion of a node that stays on the surfaces `on`. It is undefined where the node does not
  /// stay on those of `touching` with it.
  [[nodiscard]] CommonMotion motion(const Vec3& p, std::span<const Ref> on,
                                    std::span<const Ref> touching) const {
    std::vector<SurfaceMotion> motions;
    bool known = !on.empty();
    double fastest = 0;
    for (const Ref& ref : on) {
      const auto one = motion(ref, p);
      known = known && one.has_value();
      if (!one) continue;
      motions.push_back(*one);
      fastest = std::fmax(fastest, std::fabs(one->speed));
    }
    for (std::size_t i = 0; i < on.size(); ++i)
      for (std::size_t k = i + 1; k < on.size(); ++k)
        if (const auto across = tangency(on[i], on[k], p)) motions.push_back(*across);
    CommonMotion out = common_motion(motions);
    for (const Ref& ref : touching) {
      const auto one = motion(ref, p);
      known = known && one && moves_along(out.motion.required, *one, fastest);
    }
    out.defined = out.defined && known;
    return out;
  }

  /// The motion of a node that is where its surfaces are nearest to a point: how it moves with the
  /// surfaces while the point stays, and how with the point. Nothing where a surface is not there
  /// at both ends of the change, or the surfaces do not cross at the node.
  /// `freedom`: of the node: in a plane where it is on one surface, along a line where it is on a
  /// curve.
  [[nodiscard]] std::optional<FollowingMotion> nearest_motion(std::span<const Ref> on,
                                                              Freedom::Kind freedom,
                                                              const Vec3& point,
                                                              const Vec3& node) const {
    const std::optional<std::pair<Ref, Ref>> pair = that_cross(on, freedom, node);
    if (!pair) return {};
    const auto nearest = [&](const FacesOfModel& faces, const Vec3& m) -> std::optional<Vec3> {
      const Surface *a = faces.find(pair->first, now_), *b = faces.find(pair->second, now_);
      if (a == nullptr || b == nullptr) return {};
      if (freedom == Freedom::Kind::Plane) return project(*a, m);
      return foot(*a, *b, m, node, step_ / kTouch.step);
    };
    const auto difference = [&](const FacesOfModel& low, const Vec3& from, const FacesOfModel& high,
                                const Vec3& to) -> std::optional<Vec3> {
      const auto a = nearest(low, from), b = nearest(high, to);
      if (!a || !b) return {};
      return *b - *a;
    };
    const auto with_surfaces = difference(less_, point, more_, point);
    if (!with_surfaces) return {};
    FollowingMotion out{*with_surfaces / between_, {}};
    for (int k = 0; k < 3; ++k) {
      const Vec3 by = step_ * kAxes[k];
      const auto with_point = difference(now_, point - by, now_, point + by);
      if (!with_point) return {};
      out.of_point[k] = *with_point / (2 * step_);
    }
    return out;
  }

 private:
  /// The surfaces of a node: the first one twice where it is on a face, two that cross where it is
  /// on a curve.
  [[nodiscard]] std::optional<std::pair<Ref, Ref>> that_cross(std::span<const Ref> on,
                                                              Freedom::Kind freedom,
                                                              const Vec3& node) const {
    if (freedom == Freedom::Kind::Plane && !on.empty()) return std::pair{on[0], on[0]};
    if (freedom != Freedom::Kind::Line) return {};
    for (std::size_t i = 0; i < on.size(); ++i)
      for (std::size_t k = i + 1; k < on.size(); ++k)
        if (norm(cross(normal(*now_.find(on[i]), node), normal(*now_.find(on[k]), node))) >
            kFoot.sine)
          return std::pair{on[i], on[k]};
    return {};
  }

  const FacesOfModel& now_;
  FacesOfModel less_, more_;
  double between_;
  double step_;  ///< of differences in space, length
};

DesignVelocities::DesignVelocities(const Revision& revision, const Run& run)
    : revision_(revision),
      surfaces_(revision.cells.boundary, revision.model),
      faces_(revision.model),
      spread_(revision, revision.output.mesh.nodes, run) {
  find_curved_mids();
}

void DesignVelocities::find_curved_mids() {
  const OutputMesh& output = revision_.output;
  const double near = tolerance::kOnSurface * revision_.cells.boundary.bounds.diagonal();
  for (std::size_t m = 0; m < output.mids.edges.size(); ++m) {
    const auto [a, b] = output.mids.edges[m];
    const Vec3 middle = 0.5 * (output.mesh.nodes[a] + output.mesh.nodes[b]);
    const Vec3& place = output.mids.positions[m];
    if (distance(place, middle) <=
        tolerance::kStraight * distance(output.mesh.nodes[a], output.mesh.nodes[b]))
      continue;
    const auto of_a = surfaces_.at(revision_.supports()[a]);
    const auto of_b = surfaces_.at(revision_.supports()[b]);
    CurvedMid curved{static_cast<std::int32_t>(m), {}};
    std::ranges::set_intersection(of_a, of_b, std::back_inserter(curved.on));
    std::erase_if(curved.on, [&](const Ref& ref) {
      return std::fabs(signed_distance(*faces_.find(ref), place)) > near;
    });
    mids_.push_back(std::move(curved));
  }
}

CommonMotion DesignVelocities::apex_motion(const Vec3& p, const ChangingFaces& faces) const {
  const double near = tolerance::kOnSurface * revision_.cells.boundary.bounds.diagonal();
  CommonMotion out{{{}, {Freedom::Kind::None, {}}}, false};
  for (int feature = 0; feature < static_cast<int>(faces_.size()); ++feature)
    for (int face = 0; face < static_cast<int>(faces_.of(feature).size()); ++face) {
      const auto now = apex_of(*faces_.find({feature, face}));
      if (!now || distance(*now, p) > near) continue;
      if (const auto velocity = faces.apex_velocity({feature, face}))
        return {{*velocity, {Freedom::Kind::None, {}}}, true};
    }
  return out;
}

DesignVelocities::Motions DesignVelocities::motions(const ParameterChange& change) const {
  const ChangingFaces faces(faces_, change, revision_.cells.boundary.bounds.diagonal());
  const OutputMesh& output = revision_.output;
  const BoundaryModel& boundary = revision_.cells.boundary;
  Motions out;
  out.nodes.resize(output.mesh.nodes.size());
  out.undefined.resize(output.mesh.nodes.size() + output.mids.edges.size(), 0);
  for (std::size_t n = 0; n < output.mesh.nodes.size(); ++n) {
    const Support& support = revision_.supports()[n];
    if (support.kind == Support::Kind::Interior) continue;
    const bool apex =
        support.kind == Support::Kind::Vertex && boundary.vertices[support.entity].edges.empty();
    const Vec3& p = output.mesh.nodes[n];
    const CommonMotion motion =
        apex ? apex_motion(p, faces)
             : faces.motion(p, surfaces_.at(support), surfaces_.touching(support));
    out.nodes[n] = motion.motion;
    out.undefined[n] = motion.defined ? 0 : 1;
  }
  for (const CurvedMid& mid : mids_) {
    const CommonMotion motion = faces.motion(output.mids.positions[mid.mid], mid.on, {});
    out.mids.push_back(mid_motion(mid, motion.motion, faces));
    out.undefined[output.mesh.nodes.size() + mid.mid] = motion.defined ? 0 : 1;
  }
  return out;
}

FollowingMotion DesignVelocities::mid_motion(const CurvedMid& mid, const NodeMotion& on_faces,
                                             const ChangingFaces& faces) const {
  const OutputMesh& output = revision_.output;
  const auto [a, b] = output.mids.edges[mid.mid];
  const Vec3 middle = 0.5 * (output.mesh.nodes[a] + output.mesh.nodes[b]);
  if (const auto nearest = faces.nearest_motion(mid.on, on_faces.freedom.kind, middle,
                                                output.mids.positions[mid.mid]))
    return *nearest;
  FollowingMotion motion{on_faces.required, {}};
  for (int k = 0; k < 3; ++k) motion.of_point[k] = on_faces.freedom(kAxes[k]);
  return motion;
}

NodalVelocities DesignVelocities::of(const std::string& parameter, const Run& run) const {
  Motions motions = this->motions(change_of(revision_.source, parameter));
  const std::size_t corners = revision_.output.mesh.nodes.size();
  NodalVelocities out{parameter_value(revision_.source, parameter),
                      spread_.forward(motions.nodes, run), std::move(motions.undefined)};
  const auto& edges = revision_.output.mids.edges;
  out.velocities.resize(corners + edges.size());
  for (std::size_t m = 0; m < edges.size(); ++m)
    out.velocities[corners + m] = 0.5 * (out.velocities[edges[m][0]] + out.velocities[edges[m][1]]);
  for (std::size_t k = 0; k < mids_.size(); ++k) {
    Vec3& v = out.velocities[corners + mids_[k].mid];
    v = motions.mids[k](v);
  }
  return out;
}

bool DesignVelocities::Motions::is_free_as(const Motions& other) const {
  return std::ranges::equal(nodes, other.nodes, {}, &NodeMotion::freedom, &NodeMotion::freedom) &&
         std::ranges::equal(mids, other.mids, {}, &FollowingMotion::of_point,
                            &FollowingMotion::of_point);
}

std::vector<Vec3> DesignVelocities::of_required(const Motions& motions, std::span<const Vec3> seed,
                                                const Run& run) const {
  const auto corners = static_cast<std::ptrdiff_t>(revision_.output.mesh.nodes.size());
  const auto& edges = revision_.output.mids.edges;
  std::vector<Vec3> of_corners(seed.begin(), seed.begin() + corners);
  std::vector<Vec3> of_mids(seed.begin() + corners, seed.end());
  for (std::size_t k = 0; k < mids_.size(); ++k) {
    Vec3& s = of_mids[mids_[k].mid];
    s = motions.mids[k].reverse(s);
  }
  for (std::size_t m = 0; m < edges.size(); ++m)
    for (const std::int32_t n : edges[m]) of_corners[n] += 0.5 * of_mids[m];
  return spread_.reverse(motions.nodes, std::move(of_corners), run);
}

std::vector<DesignDerivative> DesignVelocities::gradient(std::span<const Vec3> seed,
                                                         std::span<const std::string> parameters,
                                                         const Run& run) const {
  std::vector<DesignDerivative> out;
  const std::size_t corners = revision_.output.mesh.nodes.size();
  Motions solved;  // for the freedoms of which `of_required` is
  std::vector<Vec3> of_required;
  for (const std::string& parameter : parameters) {
    Motions motions = this->motions(change_of(revision_.source, parameter));
    if (of_required.empty() || !motions.is_free_as(solved))
      of_required = this->of_required(motions, seed, run);
    DesignDerivative derivative;
    for (std::size_t n = 0; n < corners; ++n) {
      derivative.value += dot(of_required[n], motions.nodes[n].required);
      if (motions.undefined[n] != 0 && of_required[n] != Vec3{}) ++derivative.undefined;
    }
    for (std::size_t k = 0; k < mids_.size(); ++k) {
      const Vec3& s = seed[corners + mids_[k].mid];
      derivative.value += dot(s, motions.mids[k].required);
      if (motions.undefined[corners + mids_[k].mid] != 0 && s != Vec3{}) ++derivative.undefined;
    }
    out.push_back(derivative);
    solved = std::move(motions);
  }
  return out;
}

}  // namespace remeshd
