#pragma once

#include <span>
#include <vector>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/fuse_features.h"
#include "engine/local_fuse/gave_up.h"

namespace remeshd {

/// The boundary of some features, to be sewn into that of a model.
struct FusedPrisms {
  BoundaryParts parts;
  /// By face: whether its outward normal is that of its surface.
  std::vector<char> along;
};

/// The boundary of features that are swept along one direction, as a fuse of them gives it, but
/// without the CAD kernel: level by level of the arrangement of their outlines. Faces of planes
/// have their edges only, and one stands for all with the same plane, side and names.
///
/// Gives up where they are no such features, or their outlines are not simple enough.
///
/// Pre: the membership is the model's.
Tried<FusedPrisms> fuse_parallel_prisms(const FeatureModel& model, const Membership& membership,
                                        std::span<const int> features, const FuseFrame& frame);

}  // namespace remeshd
