#pragma once

#include <vector>

#include "engine/model/solid.h"

namespace remeshd {

/// What an edit changed.
struct Changes {
  /// For each feature of the base its index in the edited model; -1 where it is not there, not the
  /// same to the bit or not in the same order with others. The rest ascends.
  std::vector<int> kept;
  /// Round all features that were or are not kept, a little larger: elsewhere both models are the
  /// same point set.
  std::vector<Box> boxes;
};

/// Pre: the membership is the model's.
Changes find_changes(const FeatureModel& base, const FeatureModel& model,
                     const Membership& membership);

/// Whether one of the boxes has a point in common with another box.
bool touch(const std::vector<Box>& boxes, const Box& b);

}  // namespace remeshd
