#pragma once

#include <vector>

#include "engine/base/error.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Ids of the features whose surfaces pass near a place, in history order: within a millionth of
/// the model's diagonal, or the least power of ten times that, up to a hundredth, at which there
/// are two or more. Failures of the CAD kernel lie where two features nearly meet.
FeatureIds features_at(const FeatureModel& model, const Membership& membership, const Vec3& place);

FeatureIds ids_of(const FeatureModel& model, const std::vector<int>& features);

}  // namespace remeshd
