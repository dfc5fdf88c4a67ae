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
  std::string route;   ///< `kept`, `swept`, `crossed`, `fused in part`: see BoundaryParts::geometry
  std::string reason;  ///< `planar_arrangement: the end of a side nearly touches another side`, or
                       ///< an Error's message
  double seconds = 0;
};

/// The model that a mesh is made for: its merged boundary. Its cells, which only comparisons of
/// models need, are made when first asked for, unless the boundary came from a fuse of all
/// features.
struct CellularModel {
  BoundaryModel boundary;
  double volume = 0;                           ///< of all positive cells, exact
  double area = 0;                             ///< of the merged boundary
  double scale = 1;                            ///< of the CAD kernel; kernel/brep.h
  std::shared_ptr<const BoundaryParts> parts;  ///< of the boundary; boundary_parts.h
  std::shared_ptr<const ComplexOnDemand> on_demand;
  /// Given up before `parts` were made, in the order tried; of an edit only.
  std::vector<GeometryAttempt> geometry_attempts;

  /// The cells (Sect. 4.1). Safe from any number of threads.
  ///
  /// Throws Error(KERNEL_FAILURE), Error(Cancelled) where they still have to be made.
  [[nodiscard]] const CellComplex& complex(const Run& run = {}) const;
};

/// General fuse of all features (Sect. 4.1).
///
/// Throws Error(FailedPrecondition): `EMPTY_MODEL` where no cell is positive, `DISCONNECTED_MODEL`
/// where the positive cells are not connected through faces, `NON_MANIFOLD_MODEL` where one body
/// touches itself along an edge, at a vertex or, where a sphere does, at a point, `KERNEL_FAILURE`
/// where the CAD kernel raised an alert or its result failed a check. All but the first name the
/// features and the place, if known.
CellularModel build_cells(const FeatureModel& model, const Run& run);

/// The cellular model from the parts of its boundary, without a fuse. Boundary, volume and area are
/// those of the cellular model that the parts were taken from, to the bit.
///
/// Pre: parts and membership are the model's. Throws Error(NON_MANIFOLD_MODEL).
CellularModel restore_cells(const FeatureModel& model, const Membership& membership,
                            BoundaryParts parts);
CellularModel restore_cells(const FeatureModel& model, BoundaryParts parts);

}  // namespace remeshd
