#include "engine/motion/carried_boundary.h"

#include <vector>

#include "engine/motion/node_motion.h"

namespace remeshd {
namespace {

struct CarryLimits {
  int steps = 20;
  double at_rest = 1e-3;  ///< x reach
};
constexpr CarryLimits kCarry;

/// Where p goes with its surfaces: the point on all of them now that is found by Newton steps from
/// p, each the shortest that leads onto their tangent planes. `on` is in the model `then`.
Vec3 carried(const Vec3& p, std::span<const FeatureSurfaces::Ref> on, const FacesOfModel& then,
             const FacesOfModel& now, double rest) {
  Vec3 at = p;
  std::vector<SurfaceMotion> back;
  for (int step = 0; step < kCarry.steps; ++step) {
    back.clear();
    for (const auto& ref : on)
      if (const Surface* surface = now.find(ref, then))
        back.push_back({normal(*surface, at), -signed_distance(*surface, at)});
    const Vec3 by = common_motion(back).motion.required;
    at += by;
    if (norm(by) <= rest) break;
  }
  return at;
}

}  // namespace

std::optional<BoundaryMatch> match_carried(const BoundaryModel& from, const FeatureModel& then,
                                           const BoundaryModel& to, const FeatureModel& now,
                                           double reach) {
  const FeatureSurfaces surfaces(from, then);
  const FacesOfModel before(then), after(now);
  return match_boundaries(from, to, reach, [&](const Support& support, const Vec3& p) {
    return carried(p, surfaces.at(support), before, after, kCarry.at_rest * reach);
  });
}

}  // namespace remeshd
