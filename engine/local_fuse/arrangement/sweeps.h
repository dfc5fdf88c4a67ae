#pragma once

#include <span>
#include <vector>

#include "engine/local_fuse/gave_up.h"
#include "engine/model/solid.h"

namespace remeshd {

/// A side of an outline that is swept; the feature lies to its left.
struct SweepSide {
  Vec3 from, to;  ///< z = 0; equal for a circle
  bool round = false;
  Vec3 centre;
  double radius = 0;
  bool left_turn = true;  ///< of a round one: the centre lies to the left
  const SolidFace* face = nullptr;

  [[nodiscard]] bool closed() const { return round && from == to; }
};

/// A feature as an outline that is moved straight along z.
struct Sweep {
  int feature = -1;
  double low = 0, high = 0;
  const SolidFace *bottom = nullptr, *top = nullptr;  ///< at low and high
  std::vector<SweepSide> sides;                       ///< in turn, counter-clockwise
};

/// Features in a frame along whose z axis all of them are swept.
struct Sweeps {
  Transform frame;            ///< from the sweeps' coordinates to the model's
  std::vector<Sweep> sweeps;  ///< in the order of the features
};

/// Describes features of a model as sweeps along one direction. The faces pointed to are the
/// membership's own.
///
/// Gives up where a feature is no prism or cylinder, or no direction does for all.
///
/// Pre: the membership is the model's.
Tried<Sweeps> find_sweeps(const FeatureModel& model, const Membership& membership,
                          std::span<const int> features);

}  // namespace remeshd
