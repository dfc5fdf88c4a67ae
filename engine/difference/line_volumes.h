#pragma once

#include <vector>

#include "engine/base/run.h"
#include "engine/difference/point_classes.h"

namespace remeshd {

/// Volumes by class, estimated along random lines.
struct VolumeEstimate {
  std::vector<ClassTotals> features;        ///< in the order of PointClasses::features()
  std::vector<ClassTotals> feature_errors;  ///< bounds of their errors
  double newcells = 0, newcells_error = 0;
  double copycells = 0, copycells_error = 0;
};

struct LineOptions {
  /// About so many lines over the box of each feature, and again over the boxes of what changed in
  /// it, 1024 a box at least; the same for all copycells and newcells together.
  int lines = 16384;
  std::uint64_t seed = 1;  ///< of the directions and shifts
};

/// Measures every class along sheaves of parallel lines in 16 directions: on each line all
/// crossings with the surfaces of both models are exact, so a layer counts however thin it is.
///
/// What changed is measured by itself, in the boxes of PointClasses::changed, so that its error is
/// as small as the change. Each sheaf is a Fibonacci lattice with a shift of its own and gives an
/// estimate of its own; the error bounds are five standard errors of their mean.
VolumeEstimate estimate_volumes(const PointClasses& classes, const LineOptions& options,
                                const Run& run);

}  // namespace remeshd
