#pragma once

#include <vector>

#include "engine/model/solid.h"

namespace remeshd {

/// What an edit changed.
struct Changes {
  /// For each feature of the base its index in the edited model; -1 where it is gone, not identical
  /// in nature, placement and shape, or out of order. Indices other than -1 ascend.
  std::vector<int> kept;
  /// Round every feature of either model that is not kept, grown by a small margin: outside of them
  /// both models are the same point set.
  std::vector<Box> boxes;
};

/// Pre: `membership` is that of `model`.
Changes find_changes(const FeatureModel& base, const FeatureModel& model,
                     const Membership& membership);

/// Whether one of the boxes has a point in common with another box.
bool touch(const std::vector<Box>& boxes, const Box& b);

}  // namespace remeshd
