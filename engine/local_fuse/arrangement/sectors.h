#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/local_fuse/arrangement/intersection_curves.h"

namespace remeshd {

/// A set of features: bit k stands for the k-th of a list of at most 64.
using FeatureSet = std::uint64_t;

/// A half-face at a point of a curve: feature faces on one side of the curve, which end at it or
/// pass through it, and the features that lie before and behind them as one turns about the curve.
struct HalfFace {
  Vec3 direction;  ///< unit, away from the curve
  Vec3 ahead;      ///< unit normal, in the direction of turning: from `before` to `behind`
  FeatureSet before = 0, behind = 0;
  std::vector<const Patch*> covers;  ///< ascending by feature
};

/// Tells which features and faces lie round a point of a curve, by the features' closed formulas.
class Sectors {
 public:
  /// Pre: at most 64 features, ascending; patches are theirs.
  Sectors(const Membership& membership, std::span<const int> features, const Patches& patches,
          double diagonal, const Clearance& clearance);

  /// The half-faces at parameter t that have different features before and behind them, in the
  /// order of turning about the curve's tangent, from a direction fixed in the curve's frame. Gives
  /// up where they are in doubt.
  Tried<std::vector<HalfFace>> around(const IntersectionCurve& curve, double t) const;

  [[nodiscard]] bool material(FeatureSet owners) const;

 private:
  [[nodiscard]] FeatureSet owners(const Vec3& p, FeatureSet candidates) const;
  Tried<void> add_covers(HalfFace& half_face, const Vec3& p,
                         const std::vector<const Patch*>& through) const;

  const Membership& membership_;
  std::span<const int> features_;
  const Patches& patches_;
  Clearance clearance_;
  double step_;             ///< distance from a curve at which owners are tested
  std::vector<Box> boxes_;  ///< of features, a little larger
};

}  // namespace remeshd
