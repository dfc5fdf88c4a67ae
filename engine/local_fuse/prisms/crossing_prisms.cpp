#include "engine/local_fuse/prisms/crossing_prisms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/local_fuse/arrangement/planar_arrangement.h"
#include "engine/local_fuse/prisms/crossing_prism_edges.h"
#include "engine/local_fuse/sewing/cylinder_faces.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;

class CrossedParts {
 public:
  CrossedParts(std::span<const int> features, const std::vector<IntersectionCurve>& curves,
               const PrismEdges& edges, const Sectors& sectors, const FuseFrame& frame)
      : features_(features), curves_(curves), edges_(edges), sectors_(sectors) {
    brep_.scale = frame.scale;
    brep_.reference = *frame.reference;
  }

  Tried<FusedPrisms> build() {
    for (const Vec3& p : edges_.nodes) {
      brep_.vertices.push_back({p});
      brep_.points.push_back(p);
    }
    for (const PrismEdge& edge : edges_.edges) add(edge);
    if (const auto walls = add_walls(); !walls) return walls.why();
    FusedPrisms out;
    for (Family& family : families_) {
      if (family.walled) continue;
      brep_.faces.emplace_back().cells = {0, -1};
      for (const CylinderUse& use : family.uses) brep_.faces.back().edges.push_back(use.edge);
      out.parts.pieces.push_back(family.piece);
      out.along.push_back(family.along ? 1 : 0);
    }
    for (auto& [face, family] : walls_) {
      brep_.faces.push_back(std::move(face));
      out.parts.pieces.push_back(families_[family].piece);
      out.along.push_back(families_[family].along ? 1 : 0);
    }
    put_edges_in_canonical_order(brep_);
    for (std::size_t f = 0; f < out.parts.pieces.size(); ++f)
      out.parts.pieces[f].box = box_of(brep_, brep_.faces[f], out.parts.pieces[f].surface);
    out.parts.brep = std::move(brep_);
    return out;
  }

 private:
  /// Faces of one surface that the same features cover on the same sides.
  struct Family {
    BoundaryPiece piece;
    bool along = true;    ///< the outward normal is the surface's
    bool walled = false;  ///< on a cylinder
    double cut = 0;       ///< of a cylinder: angle at which to open it, see cylinder_faces
    std::vector<CylinderUse> uses;
  };

  void add(const PrismEdge& crossed) {
    const IntersectionCurve& curve = curves_[crossed.curve];
    int number = -1;
    for (const HalfFace& half_face : crossed.half_faces) {
      const bool before = sectors_.material(half_face.before);
      if (before == sectors_.material(half_face.behind)) continue;
      if (number < 0) {
        number = static_cast<int>(brep_.edges.size());
        brep_.edges.push_back(curve.round ? arc(curve, crossed) : line(crossed));
      }
      const Vec3 outward = before ? half_face.ahead : -half_face.ahead;
      const Vec3 at = curve.at(crossed.seen_at).p;
      Family& family =
          family_of(half_face, before ? half_face.before : half_face.behind, outward, at);
      const Surface& surface = family.piece.surface;
      const Vec3 axis = surface.frame.rotate({0, 0, 1});
      const bool ahead = dot(half_face.direction, cross(axis, normal(surface, at))) > 0;
      family.uses.push_back({number, ahead});
    }
  }

  /// The family of a half-face, by its covers; `material`: the features on its side with material.
  /// `outward`: its normal at the point `at`, away from the material.
  Family& family_of(const HalfFace& half_face, FeatureSet material, const Vec3& outward,
                    const Vec3& at) {
    Family fresh;
    fresh.piece.boundary = true;
    const Patch* first = half_face.covers.back();
    for (auto it = half_face.covers.rbegin(); it != half_face.covers.rend(); ++it) {
      const auto place = std::ranges::lower_bound(features_, (*it)->feature) - features_.begin();
      const bool owns = (material >> place & 1) != 0;
      auto& names = owns ? fresh.piece.material_names : fresh.piece.other_names;
      if (names.empty() && (owns || fresh.piece.material_names.empty())) first = *it;
      names.push_back({(*it)->feature, (*it)->face->name});
    }
    fresh.piece.surface = first->face->surface;
    fresh.along = dot(outward, normal(fresh.piece.surface, at)) > 0;
    const auto it = std::ranges::find_if(families_, [&](const Family& family) {
      return family.along == fresh.along && family.piece.continues(fresh.piece);
    });
    if (it != families_.end()) return *it;
    fresh.walled = first->round;
    if (first->round)
      fresh.cut =
          first->closed() ? first->first : first->first + 0.5 * first->angle + std::numbers::pi;
    return families_.emplace_back(std::move(fresh));
  }

  [[nodiscard]] BrepEdge line(const PrismEdge& crossed) const {
    return kernel::straight_edge(crossed.a, crossed.b, edges_.nodes[crossed.a],
                                 edges_.nodes[crossed.b]);
  }

  BrepEdge arc(const IntersectionCurve& curve, const PrismEdge& crossed) {
    const double angle = crossed.to - crossed.from;
    const auto at = [&](double t) { return curve.at(t); };
    BrepEdge edge;
    edge.vertices = {crossed.a, crossed.b};
    edge.tangents = {normalised(at(crossed.from).derivative),
                     normalised(at(crossed.to).derivative)};
    int parts = 0;
    if (curve.circle) {
      edge.kind = BrepEdge::Kind::Circle;
      edge.length = angle * curve.radius;
      edge.centre = curve.origin;
      edge.axis = curve.axis;
      edge.radius = curve.radius;
      const int n = kernel::steps_of(angle, kernel::kPointTurning);
      for (int i = 0; i <= n; ++i) edge.points.push_back(at(crossed.from + angle * i / n).p);
      parts = kernel::steps_of(angle, kernel::kChordTurning);
    } else {
      edge.points = kernel::points_by_halving(at, crossed.from, crossed.to,
                                              kernel::kShortestChord / brep_.scale);
      parts = std::max(2, static_cast<int>(edge.points.size()) - 1);
      edge.samples =
          kernel::integration_samples(at, crossed.from, crossed.to, edge.points.size() - 1);
      for (const auto& [p, along] : edge.samples) edge.length += norm(along);
    }
    edge.points.front() = edges_.nodes[crossed.a];
    edge.points.back() = edges_.nodes[crossed.b];
    edge.chain.push_back(crossed.a);
    for (int i = 1; i < parts; ++i) {
      edge.chain.push_back(static_cast<int>(brep_.points.size()));
      brep_.points.push_back(at(crossed.from + angle * i / parts).p);
    }
    edge.chain.push_back(crossed.b);
    return edge;
  }

  Tried<void> add_walls() {
    for (int k = 0; k < static_cast<int>(families_.size()); ++k) {
      const Family& family = families_[k];
      if (!family.walled) continue;
      auto faces = cylinder_faces(brep_, family.uses, family.piece.surface, family.cut);
      if (!faces) return faces.why();
      for (BrepFace& face : *faces) {
        if (!family.along) face.turn_over();
        face.cells = {0, -1};
        walls_.emplace_back(std::move(face), k);
      }
    }
    return {};
  }

  std::span<const int> features_;
  const std::vector<IntersectionCurve>& curves_;
  const PrismEdges& edges_;
  const Sectors& sectors_;
  Brep brep_;
  std::vector<Family> families_;
  std::vector<std::pair<BrepFace, int>> walls_;  ///< with their families
};

/// Whether every node lies, for each round wall, either on the wall or further from it than the
/// polylines of its arcs deviate from it.
bool clear_of_walls(const PrismEdges& edges, const Patches& patches, const Clearance& clearance) {
  for (const Patch& patch : patches.patches) {
    if (!patch.round) continue;
    const double clear = std::max(clearance.clear, kernel::kClearChord * patch.radius);
    for (const Vec3& p : edges.nodes) {
      if (!patch.box.contains(p, clear)) continue;
      const double d = std::fabs(patch.distance_to(p));
      if (d > 10 * clearance.same && d < clear && patch.beside(p, clear)) return false;
    }
  }
  return true;
}

}  // namespace

Tried<FusedPrisms> fuse_crossing_prisms(const FeatureModel& model, const Membership& membership,
                                        std::span<const int> features, const FuseFrame& frame) {
  if (features.size() > std::numeric_limits<FeatureSet>::digits)
    return GaveUp{"crossing_prisms", "there are too many features"};
  const auto patches = find_patches(model, membership, features);
  if (!patches) return patches.why();
  Box box;
  for (const int f : features) box.add(membership.solids()[f].bounds());
  const double diagonal = box.diagonal();
  const Clearance clearance{kSameOutline * diagonal, kClearOutline * diagonal};
  const auto curves = find_intersection_curves(*patches, clearance);
  if (!curves) return curves.why();
  const Sectors sectors(membership, features, *patches, diagonal, clearance);
  const auto edges = find_prism_edges(*curves, sectors, clearance);
  if (!edges) return edges.why();
  if (!clear_of_walls(*edges, *patches, clearance))
    return GaveUp{"crossing_prisms", "a vertex lies near a cylinder but not on it"};
  return CrossedParts(features, *curves, *edges, sectors, frame).build();
}

}  // namespace remeshd
