#pragma once

#include <optional>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"

namespace remeshd {

struct EditedModel {
  const FeatureModel& model;
  const Membership& membership;
};
struct SewingBase {
  const FeatureModel& model;
  const BoundaryParts& parts;
};

/// The result of sewing.
struct Sewn {
  std::optional<BoundaryParts> parts;     ///< none where the whole model is to be fused
  std::vector<GeometryAttempt> given_up;  ///< routes that were given up, in the order tried
};

/// The boundary parts of an edited model from those of its base. Outside of the boxes round what
/// changed both models are the same point set; inside, only the features that reach into the boxes
/// matter. So only these are fused, by fuse_parallel_prisms or fuse_crossing_prisms where they can,
/// else by the CAD kernel. Parts that meet a box are taken from the fuse, all others from the base.
/// Plane faces, which may be as large as the model, are put together from edges of both; other
/// faces and edges are replaced as a whole, so that all features near those are fused too.
///
/// A route is given up where the CAD kernel would have to fuse the whole model or fails, where the
/// result does not fit together, or where the material is in more than one piece.
///
/// Throws Error(Cancelled).
Sewn sew(const EditedModel& edited, const SewingBase& base, const Run& run);

}  // namespace remeshd
