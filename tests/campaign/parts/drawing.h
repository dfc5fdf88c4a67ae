#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/feature_model.h"

namespace remeshd::campaign {

/// Walls and gaps of a part as an engineer draws it are no narrower than this share of the smaller
/// of the details on their two sides.
inline constexpr double kNarrow = 1.0 / 3;

/// How well a part is drawn.
struct Drawing {
  /// The narrowest wall, gap or edge by the least size of the details beside it; kNarrow where none
  /// is narrower.
  double narrowest = kNarrow;
  int touching = 0;  ///< pairs of features that are tangent, or apart by next to nothing

  /// Whether an edit of a part drawn like `before` left it as it should be, or no worse than it
  /// was.
  [[nodiscard]] bool as_good_as(const Drawing& before) const {
    return narrowest >= 0.999 * before.narrowest && touching <= before.touching;
  }
};

/// Looks along normals, at 24 points of each face: what is narrow on less of a face may be missed.
Drawing look_at_drawing(const FeatureModel& model, const BoundaryModel& boundary);

/// The least extent of a feature along its own axes.
double least_size(const Feature& feature);

}  // namespace remeshd::campaign
