#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// How a mesh moves with a parameter.
struct NodalVelocities {
  double value = 0;  ///< of the parameter, in the model
  /// By corner node, then by mid-node: length per unit of the parameter.
  std::vector<Vec3> velocities;
  /// By corner node, then by mid-node: 1 where no single velocity keeps the node on its surfaces:
  /// they coincide there and move differently, or one of them is missing or of another kind on one
  /// side of the change. `velocities` then follows only some of the surfaces (`CommonMotion`).
  std::vector<std::uint8_t> undefined;
};

/// The derivative of a function of the nodes by a parameter.
struct DesignDerivative {
  double value = 0;
  std::uint32_t undefined = 0;  ///< nodes without a velocity that the function depends on
};

}  // namespace remeshd
