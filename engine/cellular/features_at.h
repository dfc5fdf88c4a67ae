#pragma once

#include <vector>

#include "engine/base/error.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Ids of the features whose surfaces pass by a place, in history order: those within a millionth
/// of the model's diagonal, and where these are not two, within as little more as it takes, up to a
/// hundredth. Failures of the CAD kernel lie where two features nearly meet.
FeatureIds features_at(const FeatureModel& model, const Membership& membership, const Vec3& place);

FeatureIds ids_of(const FeatureModel& model, const std::vector<int>& features);

}  // namespace remeshd
