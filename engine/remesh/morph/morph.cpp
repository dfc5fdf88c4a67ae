#include "engine/remesh/morph/morph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/stopwatch.h"
#include "engine/base/tolerance.h"
#include "engine/boundary/facet_faces.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/boundary_model/match_boundary.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/mesh/quality.h"
#include "engine/mesh/quality_goals.h"
#include "engine/model/solid.h"
#include "engine/nodes/nearest.h"
#include "engine/patch/node_map.h"
#include "engine/remesh/density.h"

namespace remeshd {

namespace {

/// The displacements of the anchor's nodes.
class Motion {
 public:
  Motion(const CowVector<Vec3>& anchor, const CowVector<Support>& supports, double edge_length)
      : anchor_(anchor), supports_(supports), l_(edge_length), by_(anchor.size()) {}

  /// Moves boundary nodes to their entities. Returns false where a surface moved too far.
  bool follow(const BoundaryModel& boundary) {
    const FacesOf faces(boundary);
    none_ = tolerance::kRounding * boundary.bounds.diagonal();
    for (std::size_t n = 0; n < anchor_.size(); ++n) {
      if (supports_[n].kind == Support::Kind::Interior) continue;
      for (const int f : faces(supports_[n]))
        surface_ =
            std::max(surface_, std::fabs(signed_distance(boundary.faces[f].surface, anchor_[n])));
      const Vec3 d = project(boundary, supports_[n], anchor_[n]) - anchor_[n];
      if (norm(d) <= none_) continue;
      by_[n] = d;
      moved_.push_back(anchor_[n]);
      node_ = std::max(node_, norm(d));
    }
    return surface_ < kMorphLimits.surface_motion * l_;
  }

  /// Whether no node moved out of proportion. `hidden`: how far hidden faces may have moved edges.
  [[nodiscard]] bool in_proportion(double hidden) const {
    return node_ <= std::max(kMorphLimits.leverage * surface_, hidden) + none_;
  }

  /// Moves interior nodes near moved boundary nodes by harmonic extension; the others stay.
  void extend(const CowVector<Tet>& tets, Polling& poll) {
    if (moved_.empty()) return;
    const NearestNode grid(moved_, l_);
    std::vector<std::int32_t> row(anchor_.size(), -1);
    std::vector<std::int32_t> inner;
    for (std::size_t n = 0; n < anchor_.size(); ++n) {
      poll();
      if (supports_[n].kind != Support::Kind::Interior) continue;
      const Vec3& nearest = moved_[grid.nearest(anchor_[n])];
      if (norm2(nearest - anchor_[n]) > kMorphLimits.influence * kMorphLimits.influence * l_ * l_)
        continue;
      row[n] = static_cast<std::int32_t>(inner.size());
      inner.push_back(static_cast<std::int32_t>(n));
    }
    std::vector<std::vector<std::int32_t>> neighbours(inner.size());
    for (const Tet& t : tets) {
      poll();
      for (const std::int32_t a : t)
        if (row[a] >= 0)
          for (const std::int32_t b : t)
            if (a != b) neighbours[row[a]].push_back(b);
    }
    // A neighbour counts once for every tet that the two share.
    const auto descend = [&](std::size_t k) {
      Vec3 sum;
      for (const std::int32_t b : neighbours[k]) sum += by_[b];
      by_[inner[k]] = sum / static_cast<double>(neighbours[k].size());
    };
    for (int sweep = 0; sweep < kMorphLimits.sweeps; ++sweep) {
      for (std::size_t k = 0; k < inner.size(); ++k, poll()) descend(k);
      for (std::size_t k = inner.size(); k-- > 0; poll()) descend(k);
    }
  }

  [[nodiscard]] bool moves(std::int32_t n) const { return by_[n] != Vec3{}; }
  [[nodiscard]] Vec3 place(std::int32_t n) const {
    return moves(n) ? anchor_[n] + by_[n] : anchor_[n];
  }

 private:
  const CowVector<Vec3>& anchor_;
  const CowVector<Support>& supports_;
  double l_;
  std::vector<Vec3> by_;     ///< by node
  std::vector<Vec3> moved_;  ///< boundary nodes that move, where they were
  double none_ = 0;          ///< a motion up to this is rounding
  double surface_ = 0;       ///< largest distance of an anchor position from its surface now
  double node_ = 0;          ///< largest motion of a boundary node
};

/// The worst of a tet: its volume-length, its least and its largest dihedral angle (rad).
struct Worst {
  double measure, least, largest;

  Worst(const Tet& t, const CowVector<Vec3>& p) {
    measure = volume_length(p, t);
    const auto angles = dihedral_angles(p, t);
    least = std::ranges::min(angles);
    largest = std::ranges::max(angles);
  }
  /// Whether this meets the goals wherever `then` did, and is about as good as it elsewhere.
  [[nodiscard]] bool as_good_as(const Worst& then) const {
    return measure >= std::min(goals::kLeastMeasure, then.measure - kMorphLimits.quality_loss) &&
           least >= std::min(goals::kLeastDihedral, then.least - kMorphLimits.quality_loss) &&
           largest <= std::max(goals::kLargestDihedral, then.largest + kMorphLimits.quality_loss);
  }
};

}  // namespace

std::variant<MorphedMesh, NotMorphed> verified(MorphedMesh moved, const Revision& original,
                                               const Revision& modified, const Run& run) {
  run.report("verify", 0.95);
  const Stopwatch watch;
  const Membership membership(modified.model);
  const VerifiedParent parent = verified_parent(original);
  moved.verification =
      verify(moved.mesh, moved.supports, modified.cells.boundary, modified.cells.volume, run,
             {.material = [&](const Vec3& p) { return membership.inside(p); }, .parent = &parent});
  moved.verify_seconds = watch.total();
  if (!moved.verification.valid) return NotMorphed(moved.verification.failures.front().what);
  return moved;
}

std::variant<MorphedMesh, NotMorphed> morph_mesh(const Revision& original, const Revision& modified,
                                                 const Run& run) {
  const double l = sizes_of(original, run).least();
  const BoundaryModel& boundary = modified.cells.boundary;
  const double bound = motion_bound(original.delaunay_model(), modified.model);
  if (bound > kMorphLimits.motion_bound * l) return NotMorphed{};
  const auto match =
      match_boundaries(original.cells.boundary, boundary, kMorphLimits.partner_reach * l);
  if (!match) return NotMorphed{};

  MorphedMesh c;
  c.supports = original.supports();
  for (std::size_t n = 0; n < c.supports.size(); ++n) c.supports.set(n, (*match)(c.supports[n]));
  const CowVector<Vec3>& anchor = original.delaunay_nodes();
  Motion motion(anchor, c.supports, l);
  if (!motion.follow(boundary)) return NotMorphed{};
  const double coincident = kMorphLimits.coincident * kernel_tolerance(modified.cells.parts->brep);
  if (!motion.in_proportion(std::min(bound, coincident)))
    return NotMorphed("a node would have moved more than five times as far as any surface");
  Polling poll(run);
  c.mesh.tets = original.output.mesh.tets;
  motion.extend(c.mesh.tets, poll);
  c.mesh.nodes = anchor;
  for (std::size_t n = 0; n < anchor.size(); ++n) {
    const auto node = static_cast<std::int32_t>(n);
    if (!motion.moves(node)) continue;
    ++c.nodes_moved;
    c.mesh.nodes.edit(n) = motion.place(node);
  }

  for (const Tet& t : c.mesh.tets) {
    poll();
    if (std::any_of(t.begin(), t.end(), [&](std::int32_t n) { return motion.moves(n); }) &&
        !Worst(t, c.mesh.nodes).as_good_as(Worst(t, anchor)))
      return NotMorphed("a tet would have missed the goals of quality");
  }
  return verified(std::move(c), original, modified, run);
}

}  // namespace remeshd
