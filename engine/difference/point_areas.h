#pragma once

#include <vector>

#include "engine/base/run.h"
#include "engine/difference/feature_difference.h"
#include "engine/difference/point_classes.h"

namespace remeshd {

/// Areas by class for each feature of `classes.features()`, from points spread over the faces of
/// both cellular models and looked at from both sides. The areas of each model's own faces are
/// exact, how they divide into classes is not: about one part in the square root of `samples`, and
/// strips much narrower than the samples' spacing are missed.
std::vector<ClassTotals> estimate_areas(const PointClasses& classes, const ModelView& original,
                                        const ModelView& modified, int samples, const Run& run);

}  // namespace remeshd
