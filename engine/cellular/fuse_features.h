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
  std::optional<Vec3> reference;  ///< Brep::reference of the result; none: one of its vertices
};

/// A general fuse of features, checked against their closed formulas.
struct FusedFeatures {
  CellComplex cells;                  ///< without edges and vertices
  std::vector<BoundaryPiece> pieces;  ///< one for each face
};

/// Fuses all features of a model and hands the result to `use`. Where the kernel, a check or `use`
/// fails with KERNEL_FAILURE, tries again in another way, so `use` may be called several times. The
/// model that comes out does not depend on the way.
///
/// Throws Error(KERNEL_FAILURE) with features and place, what `use` throws, Error(Cancelled).
void fuse_features(const FeatureModel& model, const Membership& membership, const FuseFrame& frame,
                   const Run& run, const std::function<void(FusedFeatures)>& use);

/// The frame for a model by itself: a scale for its size, no reference.
FuseFrame fuse_frame(const Membership& membership);

}  // namespace remeshd
