#pragma once

#include <vector>

#include "engine/kernel/curve_points.h"
#include "engine/local_fuse/arrangement/patches.h"

namespace remeshd {

/// A whole curve that edges lie on: a line, or a circle or ellipse where a plane cuts a cylinder.
struct IntersectionCurve {
  /// Where an edge may end.
  struct Split {
    double t = 0;
    bool seam = false;  ///< at a round wall's seam, where there always is a vertex
  };

  bool round = false, circle = false;
  Vec3 origin, direction;    ///< of a line; `origin` of a round one is its centre
  double low = 0, high = 0;  ///< of a line: parameters where edges may lie
  Vec3 u, v;                 ///< of a round one: origin + cos t u + sin t v
  Vec3 x, y, axis;           ///< of a round one: the cylinder's; t is the angle about the axis
  double radius = 0;         ///< of a round one: the cylinder's
  std::vector<Split> splits;
  std::vector<int> features;        ///< whose patches or edges it comes from
  std::vector<const Patch*> seams;  ///< walls whose seams lie on it

  [[nodiscard]] kernel::CurvePoint at(double t) const;
  [[nodiscard]] double parameter(const Vec3& p) const;  ///< (-pi, pi] of a round one
};

/// Lengths that tell what coincides from what is apart; between them it is in doubt.
struct Clearance {
  double same = 0, clear = 0;
};

/// The curves on which the patches' own edges lie, and those in which patches of two features
/// cross, split wherever another patch may cross them. Not every part between two splits is an
/// edge.
///
/// Gives up where round walls cross whose axes are not parallel, or patches nearly touch or
/// coincide, or there are very many.
Tried<std::vector<IntersectionCurve>> find_intersection_curves(const Patches& patches,
                                                               const Clearance& clearance);

}  // namespace remeshd
