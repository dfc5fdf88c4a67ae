#pragma once

#include "engine/base/run.h"
#include "engine/model/feature_model.h"
#include "engine/model/selection/selected_faces.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Whether a part of a selector names a whole feature and its condition holds at some of the
/// material that the feature has in the model. It is looked for at the points of a lattice in the
/// feature's bounding box.
bool has_material(const SelectedFaces& on, const FeatureModel& model, const Membership& membership,
                  const Run& run);

}  // namespace remeshd
