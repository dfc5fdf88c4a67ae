#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/local_fuse/arrangement/intersection_curves.h"

namespace remeshd {

/// Features by place in a list of at most 64.
using FeatureSet = std::uint64_t;

/// A half-face of feature faces that ends at a point of a curve, or passes through it: what lies
/// before and behind it, turning about the curve.
struct HalfFace {
  Vec3 direction;  ///< unit, away from the curve
  Vec3 ahead;      ///< unit, at right angles to the half-face, to what is behind it
  FeatureSet before = 0, behind = 0;
  std::vector<const Patch*> covers;  ///< ascending by feature
};

/// Looks round the points of curves by the features' closed formulas.
class Sectors {
 public:
  /// Pre: at most 64 features; patches are theirs.
  Sectors(const Membership& membership, std::span<const int> features, const Patches& patches,
          double diagonal, const Clearance& clearance);

  /// The half-faces where what lies on both sides differs, as they turn about the curve from the
  /// same direction in its own frame at every point. Gives up where that is in doubt.
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
  double step_;             ///< to where is looked
  std::vector<Box> boxes_;  ///< of features, a little larger
};

}  // namespace remeshd
