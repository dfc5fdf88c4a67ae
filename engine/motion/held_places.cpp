#include "engine/motion/held_places.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerance.h"
#include "engine/boundary/facet_faces.h"

namespace remeshd {
namespace {

struct PlacingLimits {
  int passes = 30;
  double at_rest = 1e-13;  ///< x the model's diagonal: a pass that moves nodes less is the last
};
constexpr PlacingLimits kPlacing;

/// Unit tangent of a model edge's curve at one of its points.
Vec3 tangent(const BoundaryModel& boundary, const BoundaryEdge& edge, const Vec3& p) {
  switch (edge.curve.kind) {
    case Curve::Kind::Line:
      return edge.curve.direction;
    case Curve::Kind::Circle:
      return normalised(cross(edge.curve.direction, p - edge.curve.origin));
    case Curve::Kind::Other:
      break;
  }
  if (edge.faces.size() == 2) {
    const Vec3 along = cross(normal(boundary.faces[edge.faces[0]].surface, p),
                             normal(boundary.faces[edge.faces[1]].surface, p));
    if (norm(along) > 1e-6) return normalised(along);
  }
  // Tangent surfaces: the polyline's own direction.
  double nearest = HUGE_VAL;
  Vec3 along{1, 0, 0};
  for (std::size_t k = 1; k < edge.points.size(); ++k) {
    const double d = norm2(0.5 * (edge.points[k - 1] + edge.points[k]) - p);
    if (d >= nearest || edge.points[k] == edge.points[k - 1]) continue;
    nearest = d;
    along = normalised(edge.points[k] - edge.points[k - 1]);
  }
  return along;
}

/// The motion that a node at `anchor` needs to get onto its support, near to where it is now.
NodeMotion onto_support(const BoundaryModel& boundary, const Support& support, const Vec3& anchor,
                        const Vec3& now) {
  const Vec3 target = project(boundary, support, now);
  const Vec3 by = target - anchor;
  if (support.kind == Support::Kind::Edge) {
    const Vec3 along = tangent(boundary, boundary.edges[support.entity], target);
    return {by - dot(along, by) * along, {Freedom::Kind::Line, along}};
  }
  const Vec3 across = normal(boundary.faces[support.entity].surface, target);
  return {dot(across, by) * across, {Freedom::Kind::Plane, across}};
}

class Placing {
 public:
  Placing(const CowVector<Vec3>& anchor, const std::vector<Support>& supports,
          const BoundaryModel& boundary)
      : anchor_(anchor),
        supports_(supports),
        boundary_(boundary),
        motions_(anchor.size()),
        u_(anchor.size()) {}

  void vertices() {
    for (std::size_t n = 0; n < supports_.size(); ++n)
      if (supports_[n].kind == Support::Kind::Vertex)
        u_[n] = boundary_.vertices[supports_[n].entity].position - anchor_[n];
  }

  /// Places nodes of edges, or of faces: spreads their motions, brings them back onto what they
  /// stand on, and repeats that until they rest.
  void slide(const Spread& stage, const Run& run) {
    const double rest = kPlacing.at_rest * boundary_.bounds.diagonal();
    for (int pass = 0; pass < kPlacing.passes; ++pass) {
      for (const std::int32_t n : stage.nodes())
        motions_[n] = onto_support(boundary_, supports_[n], anchor_[n], anchor_[n] + u_[n]);
      const std::vector<Vec3> before = u_;
      stage.forward(motions_, u_, run, Spread::Accuracy::Rough);
      double moved = 0;
      for (const std::int32_t n : stage.nodes())
        moved = std::max(moved, distance(u_[n], before[n]));
      if (moved <= rest) break;
    }
    for (const std::int32_t n : stage.nodes())
      u_[n] = project(boundary_, supports_[n], anchor_[n] + u_[n]) - anchor_[n];
  }

  void interior(const Spread& stage, const Run& run) { stage.forward(motions_, u_, run); }

  [[nodiscard]] HeldPlaces take() const {
    HeldPlaces out;
    const FacesOf faces(boundary_);
    const double none = tolerance::kRounding * boundary_.bounds.diagonal();
    out.nodes.resize(u_.size());
    for (std::size_t n = 0; n < u_.size(); ++n) {
      out.nodes[n] = norm(u_[n]) <= none ? anchor_[n] : anchor_[n] + u_[n];
      for (const int f : faces(supports_[n]))
        out.surface_motion = std::max(
            out.surface_motion, std::fabs(signed_distance(boundary_.faces[f].surface, anchor_[n])));
    }
    return out;
  }

 private:
  const CowVector<Vec3>& anchor_;
  const std::vector<Support>& supports_;
  const BoundaryModel& boundary_;
  std::vector<NodeMotion> motions_;
  std::vector<Vec3> u_;
};

}  // namespace

HeldPlaces held_places(const CowVector<Vec3>& anchor, const MeshSpread& spread,
                       const std::vector<Support>& supports, const BoundaryModel& boundary,
                       const Run& run) {
  Placing placing(anchor, supports, boundary);
  placing.vertices();
  placing.slide(spread.edges(), run);
  placing.slide(spread.faces(), run);
  placing.interior(spread.interior(), run);
  return placing.take();
}

}  // namespace remeshd
