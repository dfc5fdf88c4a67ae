#pragma once

#include <span>
#include <vector>

#include "engine/base/region.h"
#include "engine/base/vec.h"
#include "engine/nodes/nearest.h"

namespace remeshd {

/// The places within some distance of one of some points.
class Surroundings {
 public:
  /// `reach`: the distance, a length > 0. `within`: `meets` counts only what lies in this box.
  Surroundings(std::span<const Vec3> points, double reach, const Box& within);

  [[nodiscard]] bool holds(const Vec3& p) const;
  /// Whether it may hold a point of the box.
  [[nodiscard]] bool may_hold_some_of(const Box& box) const;
  /// Whether a ball meets, in `within`, the box round a connected part of these places. True where
  /// the radius is not finite; false where no part reaches into `within`.
  [[nodiscard]] bool meets(const Vec3& centre, double radius) const;

 private:
  double reach_;
  Region region_;
  NearestNode grid_;
  Box box_;                 ///< round all of `boxes_`
  std::vector<Box> boxes_;  ///< what of `parts_` lies in `within`
  std::vector<Box> parts_;  ///< round the connected parts
};

}  // namespace remeshd
