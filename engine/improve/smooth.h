#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/improve/boundary_rules.h"
#include "engine/improve/local_mesh.h"
#include "engine/improve/score.h"

namespace remeshd {

/// Moves single nodes so that the worst of their tets gets better: ascent along the shortest vector
/// in the hull of the gradients of the tets that are worst or nearly so (Freitag & Ollivier-Gooch
/// 1997). Nodes on the boundary slide on their face or curve.
class Smoother {
 public:
  Smoother(const LocalMesh& mesh, const BoundaryRules& rules) : mesh_(mesh), rules_(rules) {}

  /// Post: true with the new place in `position` where the worst tet at the node gets better by at
  /// least `gain`. Ends early once the worst is at `enough` or above.
  bool smooth(std::int32_t node, double enough, double gain, Vec3& position);

  /// One step down the sum of measure^-8 over the node's tets. Where several nodes hold each other
  /// in place because each has a tet that is worst, rounds of such steps over all of them still
  /// make progress; the worst tet of a single node may get worse on the way.
  /// `facets`: from BoundaryRules::facets_at. Pre: the node may move.
  /// Post: true with the new place in `position` where the sum gets less; no tet is inverted.
  bool energy_descent_step(std::int32_t node, std::span<const Triangle> facets, Vec3& position);

  /// The same with `Score::energy` in place of measure^-8, so that angles count.
  bool energy_descent_step(std::int32_t node, const Score& score, int steepness, Vec3& position);

 private:
  /// A tet at the node: (node, b, c, d) is positive.
  struct Opposite {
    Vec3 b, c, d;
  };
  struct Slope {
    double quality;
    Vec3 gradient;
  };

  void gather(std::int32_t node);
  /// Worst tet with the node at p; stops as soon as one is at or below `floor`.
  [[nodiscard]] double worst(const Vec3& p, double floor) const;
  /// Qualities and gradients at p; returns the worst quality.
  double slopes(const Vec3& p);
  /// Shortest vector in the hull of the gradients of all tets within `band` of the worst.
  [[nodiscard]] Vec3 ascent(double worst, double band) const;

  /// Projects a direction at p on the tangent of the node's surface or curve; false where next to
  /// nothing is left of it.
  bool slide(std::int32_t node, const Vec3& p, Vec3& direction) const;
  [[nodiscard]] double energy(const Vec3& p, double limit) const;
  /// One step along a direction, halved until it lowers the energy from `now`; false where none
  /// does. energy(place, limit) may stop adding up once it has reached the limit.
  template <class Energy>
  bool step_down(std::int32_t node, std::span<const Triangle> facets, Vec3 direction, double now,
                 const Energy& energy, Vec3& position) const;

  const LocalMesh& mesh_;
  const BoundaryRules& rules_;
  std::vector<Opposite> star_;
  std::vector<Slope> slopes_;
  std::vector<Triangle> facets_;
  double length_ = 0;  ///< mean edge length at the node
};

}  // namespace remeshd
