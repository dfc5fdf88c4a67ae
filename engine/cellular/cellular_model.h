#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/cellular/cell_complex.h"
#include "engine/model/feature_model.h"

namespace remeshd {

class ComplexOnDemand;
class Membership;
struct BoundaryParts;

/// A way to the boundary of an edited model that was tried and given up.
struct GeometryAttempt {
  std::string route;   ///< `swept`, `crossed`, `fused in part`, as BoundaryParts::geometry has them
  std::string reason;  ///< `planar_arrangement: the end of a side nearly touches another side`, or
                       ///< an Error's message
  double seconds = 0;
};

/// What a mesh is made for. The cells behind it, which only comparisons of models look at, are made
/// when asked for.
struct CellularModel {
  BoundaryModel boundary;
  double volume = 0;                           ///< of all positive cells, exact
  double area = 0;                             ///< of the merged boundary
  double scale = 1;                            ///< of the CAD kernel; kernel/brep.h
  std::shared_ptr<const BoundaryParts> parts;  ///< of the boundary; boundary_parts.h
  std::shared_ptr<const ComplexOnDemand> on_demand;
  /// Before the parts were made as they are, in the order tried; of an edit only.
  std::vector<GeometryAttempt> geometry_attempts;

  /// The cells (Sect. 4.1). Any number of threads may ask.
  ///
  /// Throws Error(KERNEL_FAILURE), Error(Cancelled) where they have to be made.
  [[nodiscard]] const CellComplex& complex(const Run& run = {}) const;
};

/// General fuse of all features (Sect. 4.1).
///
/// Throws Error(FailedPrecondition): `EMPTY_MODEL` where no cell is positive, `DISCONNECTED_MODEL`
/// where the positive cells do not hang together by faces, `NON_MANIFOLD_MODEL` where one body
/// touches itself along an edge, at a vertex or, where a sphere does, at a point, `KERNEL_FAILURE`
/// where the CAD kernel raised an alert or a membership sample disagrees with its result; the last
/// two name the features and the place.
CellularModel build_cells(const FeatureModel& model, const Run& run);

/// The same from the parts of a boundary that were made for this model, to the bit.
///
/// Pre: the membership is the model's.
CellularModel restore_cells(const FeatureModel& model, const Membership& membership,
                            BoundaryParts parts);
CellularModel restore_cells(const FeatureModel& model, BoundaryParts parts);

}  // namespace remeshd
