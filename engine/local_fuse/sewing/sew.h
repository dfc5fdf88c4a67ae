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

/// What came of sewing.
struct Sewn {
  std::optional<BoundaryParts> parts;     ///< none where the whole model is to be fused
  std::vector<GeometryAttempt> given_up;  ///< the routes to them that were, in the order tried
};

/// The boundary parts of an edited model from those of its base. Outside of the boxes round what
/// changed both models are the same point set; inside of them the features that reach into them
/// decide. So these few are fused, without the CAD kernel where fuse_parallel_prisms.h or
/// fuse_prisms.h do, and parts that meet a box are taken from there, all others from the base.
/// Faces of planes, which may be as large as the model, are put together from edges of both; other
/// faces and edges come as a whole, so all features near them are fused too.
///
/// Gives up where the kernel would have to fuse the whole model, or what comes out does not fit
/// together, or the material is in more than one piece, or the CAD kernel fails.
///
/// Throws Error(Cancelled).
Sewn sew(const EditedModel& edited, const SewingBase& base, const Run& run);

}  // namespace remeshd
