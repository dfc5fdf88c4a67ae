#pragma once

#include <string>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Names the feature faces at a point of the merged boundary.
class FacetNames {
 public:
  /// Keeps references to all three.
  FacetNames(const FeatureModel& model, const Membership& membership,
             const BoundaryModel& boundary);

  /// `hole1.wall`: all feature faces that contain the point of BoundaryFace `face` nearest to p;
  /// the latest owner on the material side first, then the others, latest first. Never empty: on a
  /// seam, to within rounding, the first name of the whole face stands in.
  [[nodiscard]] std::vector<std::string> operator()(int face, const Vec3& p) const;

 private:
  [[nodiscard]] bool passes(const FaceName& name, const Vec3& p) const;

  const FeatureModel& model_;
  const Membership& membership_;
  const BoundaryModel& boundary_;
  const double tolerance_;
};

}  // namespace remeshd
