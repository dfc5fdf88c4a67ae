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
/// without the CAD kernel: from the arrangement of their outlines, slab by slab. A plane face has
/// its edges only, no triangles or measures, and stands for all with the same plane, side and
/// names.
///
/// Gives up where the features have no such direction, or their outlines are not simple enough.
///
/// Pre: the membership is the model's.
Tried<FusedPrisms> fuse_parallel_prisms(const FeatureModel& model, const Membership& membership,
                                        std::span<const int> features, const FuseFrame& frame);

}  // namespace remeshd
