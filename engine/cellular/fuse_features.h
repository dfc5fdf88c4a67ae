#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/cell_complex.h"
#include "engine/model/solid.h"

namespace remeshd {

/// What all fuses for one model have in common.
struct FuseFrame {
  double scale = 1;               ///< kernel/brep.h
  std::optional<Vec3> reference;  ///< of volumes; a vertex where there is none
};

/// A general fuse of features, checked against their closed formulas.
struct FusedFeatures {
  CellComplex cells;                  ///< without edges and vertices
  double volume = 0;                  ///< of all positive cells, exact
  std::vector<BoundaryPiece> pieces;  ///< one for each face
};

/// Fuses all features of a model and hands the result to `use`; again, in another way, where the
/// kernel or `use` fail with a KERNEL_FAILURE. What comes out does not depend on the way.
///
/// Throws Error(KERNEL_FAILURE) with features and place, what `use` throws, Error(Cancelled).
void fuse_features(const FeatureModel& model, const Membership& membership, const FuseFrame& frame,
                   const Run& run, const std::function<void(FusedFeatures)>& use);

/// The frame of a model of its own.
FuseFrame fuse_frame(const Membership& membership);

}  // namespace remeshd
