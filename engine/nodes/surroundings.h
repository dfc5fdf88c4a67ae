#pragma once

#include <span>
#include <vector>

#include "engine/base/region.h"
#include "engine/base/vec.h"
#include "engine/nodes/nearest.h"

namespace remeshd {

/// What is within some distance of one of some points.
class Surroundings {
 public:
  /// `reach`: the distance, a length > 0. `within`: all that is asked for is in this box.
  Surroundings(std::span<const Vec3> points, double reach, const Box& within);

  [[nodiscard]] bool holds(const Vec3& p) const;
  /// Whether there may be a point in the box that it holds.
  [[nodiscard]] bool may_hold_some_of(const Box& box) const;
  /// Whether a ball meets the boxes round the parts that hang together; true where the radius is
  /// not finite, false where there is nothing.
  [[nodiscard]] bool meets(const Vec3& centre, double radius) const;

 private:
  double reach_;
  Region region_;
  NearestNode grid_;
  Box box_;                 ///< round all of it
  std::vector<Box> boxes_;  ///< cover it
  std::vector<Box> parts_;  ///< the same, also what is not within the box that is asked for
};

}  // namespace remeshd
